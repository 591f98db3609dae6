// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algebra/described.h"
#include "almanac/ephemeris.h"
#include "almanac/instant.h"
#include "eclipse/shadow_cone.h"

namespace coppermoon::eclipse {

enum class EclipseType { penumbral, partial, total };

/// Name of a type of eclipse: "penumbral", "partial" or "total".
const char* name(EclipseType type);

/// Moments at which the Moon's limb touches the edge of the shadow: from outside (P1, P4 for the penumbra; U1, U4 for
/// the umbra) or from inside (U2, U3 for the umbra). A contact that does not occur in the eclipse is empty.
struct Contacts {
  std::optional<almanac::Instant> P1, U1, U2, U3, U4, P4;
};

struct Eclipse {
  almanac::Instant greatest;  ///< moment of the Moon's least angle from the shadow axis
  EclipseType type = EclipseType::penumbral;
  /// distance of the Moon's centre from the shadow axis at greatest eclipse, in Earth radii; positive north of the axis
  double gamma = 0;
  double umbral_magnitude = 0, penumbral_magnitude = 0;  ///< part of the Moon's diameter in shadow
  Contacts contacts;
  almanac::Calendar calendar = almanac::Calendar::gregorian;  ///< used for dates in reports
};

/// The contacts that occur in an eclipse, with their names ("P1" … "P4"), in order of time.
algebra::ByName<almanac::Instant> by_name(const Contacts& contacts);

template <class Field>
void describe_numbers(Field&& is, const Eclipse& eclipse) {
  is("greatest", eclipse.greatest,
     "moment at which the Moon's centre is at its least angle from the shadow's axis, UTC");
  is("type", algebra::Word{name(eclipse.type), {"penumbral", "partial", "total"}}, "its type");
  is("gamma", eclipse.gamma, algebra::unit::earth_radii,
     "distance of the Moon's centre from the axis then, north positive");
  is("umbral_magnitude", eclipse.umbral_magnitude, "share of the Moon's diameter in the umbra");
  is("penumbral_magnitude", eclipse.penumbral_magnitude,
     "share of the Moon's diameter in the penumbra");
}

template <class Field>
void describe(Field&& is, const Eclipse& eclipse) {
  is.a("Eclipse", "An eclipse of the Moon.");
  describe_numbers(is, eclipse);
  is("contacts", by_name(eclipse.contacts),
     "moments by the names of the contacts that it has: P1, U1, U2, U3, U4, P4, UTC");
}

/// Title with the date in the eclipse's calendar, such as "Total eclipse of the Moon, 2018-07-27".
std::string title(const Eclipse& eclipse);

/// Eclipses whose greatest phase lies between two moments, in order of time.
///
/// The fast theory moon98 finds eclipses among the full Moons near a node; `theory` then refines them.
///
/// Accuracy  compared with 55 published times, 1951 to 2025: 7.9 s at worst and 2.4 s on average with elp_2000_82b,
///           11.9 s and 4.0 s with moon98 (which may err by 36 s). The largest differences are in 2025, because the
///           published times use a predicted ΔT (Espenak & Meeus 2006) that is 5.7 s too large. Before 1900 and after
///           2100, the accuracy is limited by the ephemerides and ΔT
/// Throws    Error  if `to` is before `from`
std::vector<Eclipse> eclipses_between(
    const almanac::Instant& from, const almanac::Instant& to, ShadowConvention convention,
    almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

/// Moments of the contacts and of greatest eclipse, with their names ("P1" … "greatest" … "P4"), in order of time.
std::vector<std::pair<std::string, almanac::Instant>> contacts_of(const Eclipse& eclipse);

/// The eclipse, if any, whose greatest phase, rounded to the second, falls on the day that begins at `midnight`.
std::optional<Eclipse> eclipse_of_day(const almanac::Instant& midnight,
                                      ShadowConvention convention);

/// The eclipse, if any, that is in progress at a moment: between P1 and P4, both of them rounded to the second, as in
/// reports.
std::optional<Eclipse> eclipse_at(const almanac::Instant& instant, ShadowConvention convention,
                                  almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

/// The eclipse whose greatest phase is nearest in time to a moment, whether before or after it.
Eclipse nearest_eclipse(const almanac::Instant& instant, ShadowConvention convention,
                        almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

}  // namespace coppermoon::eclipse
