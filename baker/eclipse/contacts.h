// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "almanac/ephemeris.h"
#include "almanac/instant.h"
#include "eclipse/shadow_cone.h"

namespace coppermoon::eclipse {

enum class EclipseType { penumbral, partial, total };

/// "penumbral", "partial", "total".
const char* name(EclipseType type);

/// When the Moon's disc touches the shadow from outside (P1, P4 the penumbra; U1, U4 the umbra) and
/// from inside (U2, U3 the umbra). Empty: there is no such contact.
struct Contacts {
  std::optional<almanac::Instant> P1, U1, U2, U3, U4, P4;
};

struct Eclipse {
  almanac::Instant greatest;  ///< the Moon's centre at its least angle from the axis
  EclipseType type = EclipseType::penumbral;
  double gamma = 0;  ///< its distance from the axis then, in Earth radii, north positive
  double umbral_magnitude = 0, penumbral_magnitude = 0;  ///< share of the Moon's diameter immersed
  Contacts contacts;
  almanac::Calendar calendar = almanac::Calendar::gregorian;  ///< in which its dates are told
};

/// "Total eclipse of the Moon, 2018-07-27", in the eclipse's calendar.
std::string title(const Eclipse& eclipse);

/// The eclipses whose greatest phase lies between two moments, in their order.
///
/// Every full Moon near a node is searched with moon98, every eclipse refined with `theory`.
///
/// Accuracy  against 55 published times, 1951 to 2025: 7.9 s worst and 2.4 s on average with
///           elp_2000_82b, 11.9 s and 4.0 s with moon98 (36 s is possible). The worst are of 2025,
///           where the ΔT predicted for them by Espenak & Meeus (2006) is 5.7 s too large. Before
///           1900 and after 2100 as the ephemerides and ΔT are
/// Throws    Error  when `to` is before `from`
std::vector<Eclipse> eclipses_between(
    const almanac::Instant& from, const almanac::Instant& to, ShadowConvention convention,
    almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

/// Contacts and the greatest phase by their names ("P1" … "greatest" … "P4"), in order of time.
std::vector<std::pair<std::string, almanac::Instant>> contacts_of(const Eclipse& eclipse);

/// The eclipse whose greatest phase, to the second, falls on the day of 24 h that begins at a moment, if
/// there is one.
std::optional<Eclipse> eclipse_of_day(const almanac::Instant& midnight,
                                      ShadowConvention convention);

/// The eclipse that is under way, from P1 to P4, if there is one. Contacts count as they are written, to
/// the second: either may be half a second away.
std::optional<Eclipse> eclipse_at(const almanac::Instant& instant, ShadowConvention convention,
                                  almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

/// The eclipse whose greatest phase is nearest in time, before or after.
Eclipse nearest_eclipse(const almanac::Instant& instant, ShadowConvention convention,
                        almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

}  // namespace coppermoon::eclipse
