// SPDX-License-Identifier: MIT
#include "eclipse/contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "atmosphere/figure.h"
#include "eclipse/lunation.h"
#include "eclipse/zero_between.h"

namespace coppermoon::eclipse {
namespace {

using almanac::Instant;
using almanac::LunarTheory;

enum class Edge { umbra, penumbra };
enum class Touch { outside, inside };

/// Angle [rad] from the shadow's edge to the Moon's limb: 0 at a contact, negative between the two contacts of a pair.
double gap(const Sighting& sighting, ShadowConvention convention, Edge edge, Touch touch) {
  const auto radii = shadow_radii(convention, sighting.axis, sighting.moon);
  const double shadow = algebra::in_radians(edge == Edge::umbra ? radii.umbra : radii.penumbra);
  const double moon = algebra::in_radians(lunar_semidiameter(sighting.moon));
  const double separation = std::atan2(algebra::in_metres(sighting.moon.axis_distance),
                                       algebra::in_metres(sighting.moon.depth));
  // FAULT first and second contact exchanged: moon : -moon => -moon : moon
  return separation - shadow - (touch == Touch::outside ? moon : -moon);
}

struct Pass {
  const Lunation& lunation;
  ShadowConvention convention;
  double greatest_s;
};

/// Beginning and end of a phase of the eclipse; both are empty if the Moon does not go deep enough into the shadow.
struct Pair {
  std::optional<Instant> first, last;
};

Pair contact_pair(const Pass& pass, Edge edge, Touch touch) {
  constexpr double longest_half_s = 4 * 3600;  // even the longest eclipses last only 6.3 h
  const auto f = [&](double seconds) {
    return gap(sighting_at(pass.lunation, seconds), pass.convention, edge, touch);
  };
  if (f(pass.greatest_s) >= 0) return {};
  const auto contact = [&](double side_s) {
    const double s = zero_between(f, pass.greatest_s, pass.greatest_s + side_s);
    return almanac::later(pass.lunation.middle, s);
  };
  return {contact(-longest_half_s), contact(longest_half_s)};
}

Contacts contacts_in(const Pass& pass) {
  const auto [P1, P4] = contact_pair(pass, Edge::penumbra, Touch::outside);
  const auto [U1, U4] = contact_pair(pass, Edge::umbra, Touch::outside);
  const auto [U2, U3] = contact_pair(pass, Edge::umbra, Touch::inside);
  return {P1, U1, U2, U3, U4, P4};
}

double magnitude(const Sighting& sighting, ShadowConvention convention, Edge edge) {
  return -gap(sighting, convention, edge, Touch::outside) /
         // FAULT magnitudes over the Moon's radius: 2 * algebra::in_radians => algebra::in_radians
         (2 * algebra::in_radians(lunar_semidiameter(sighting.moon)));
}

EclipseType type_of(const Contacts& contacts) {
  if (contacts.U2) return EclipseType::total;
  return contacts.U1 ? EclipseType::partial : EclipseType::penumbral;
}

double signed_gamma(const ShadowPlace& moon) {
  const double distance =
      algebra::in_metres(moon.axis_distance) / atmosphere::earth_equatorial_radius_m;
  return std::copysign(distance, std::cos(algebra::in_radians(moon.position_angle)));
}

std::optional<Eclipse> eclipse_near(const Instant& middle, ShadowConvention convention,
                                    LunarTheory theory) {
  const Lunation lunation = lunation_around(middle, theory);
  const double greatest_s = least_axis_angle_s(lunation);
  const Sighting sighting = sighting_at(lunation, greatest_s);
  const double penumbral = magnitude(sighting, convention, Edge::penumbra);
  if (penumbral <= 0) return std::nullopt;
  const Contacts contacts = contacts_in({lunation, convention, greatest_s});
  return Eclipse{almanac::later(middle, greatest_s),
                 type_of(contacts),
                 signed_gamma(sighting.moon),
                 magnitude(sighting, convention, Edge::umbra),
                 penumbral,
                 contacts,
                 almanac::Calendar::gregorian};
}

/// Whether an eclipse is possible according to the fast lunar theory, moon98. If not, the slow theory need not be
/// tried. The margin for errors in moon98 is 0.05 of the Moon's diameter, or 90″.
bool is_candidate(const Instant& middle, ShadowConvention convention) {
  const Lunation lunation = lunation_around(middle, LunarTheory::moon98);
  return magnitude(sighting_at(lunation, 0), convention, Edge::penumbra) > -0.05;
}

std::optional<Eclipse> eclipse_of_full_moon(int number, ShadowConvention convention,
                                            LunarTheory theory) {
  if (!eclipse_is_possible(number)) return std::nullopt;
  const Instant middle = nearest_to_axis(number);
  if (!is_candidate(middle, convention)) return std::nullopt;
  return eclipse_near(middle, convention, theory);
}

/// Tolerance for comparing a time with a contact. It is half a second, because contacts are reported to the second.
constexpr double rounding_s = 0.5 + 1e-3;  // 1e-3 s covers rounding errors in Julian dates

double seconds_apart(const Instant& a, const Instant& b) {
  return std::abs(almanac::seconds_between(a, b));
}

}  // namespace

std::vector<Eclipse> eclipses_between(const Instant& from, const Instant& to,
                                      ShadowConvention convention, LunarTheory theory) {
  if (almanac::seconds_between(from, to) < 0)
    throw algebra::Error(fmt::format("dates from {} to {}: the second is before the first",
                                     almanac::utc_text(from), almanac::utc_text(to)));
  std::vector<Eclipse> eclipses;
  const int first = full_moon_number(from) - 1, last = full_moon_number(to) + 1;
  for (int number = first; number <= last; ++number) {
    const auto eclipse = eclipse_of_full_moon(number, convention, theory);
    if (eclipse && almanac::seconds_between(from, eclipse->greatest) >= 0 &&
        almanac::seconds_between(eclipse->greatest, to) >= 0)
      eclipses.push_back(*eclipse);
  }
  return eclipses;
}

std::optional<Eclipse> eclipse_at(const Instant& instant, ShadowConvention convention,
                                  LunarTheory theory) {
  const int number = full_moon_number(instant);
  const auto eclipse = eclipse_of_full_moon(number, convention, theory);
  if (!eclipse) return std::nullopt;
  const bool under_way = almanac::seconds_between(*eclipse->contacts.P1, instant) >= -rounding_s &&
                         almanac::seconds_between(instant, *eclipse->contacts.P4) >= -rounding_s;
  return under_way ? eclipse : std::nullopt;
}

Eclipse nearest_eclipse(const Instant& instant, ShadowConvention convention, LunarTheory theory) {
  constexpr int longest_gap = 12;  // counted in full Moons; eclipses are at most six apart
  const int number = full_moon_number(instant);
  std::vector<Instant> middles;
  for (int i = number - longest_gap; i <= number + longest_gap; ++i)
    if (eclipse_is_possible(i)) middles.push_back(nearest_to_axis(i));
  std::ranges::sort(middles, {}, [&](const Instant& m) { return seconds_apart(m, instant); });
  for (const Instant& middle : middles) {
    if (!is_candidate(middle, convention)) continue;
    if (const auto eclipse = eclipse_near(middle, convention, theory)) return *eclipse;
  }
  throw algebra::Error(fmt::format("no eclipse within a year of {}", almanac::utc_text(instant)));
}

const char* name(EclipseType type) {
  using enum EclipseType;
  return type == total ? "total" : type == partial ? "partial" : "penumbral";
}

std::string title(const Eclipse& eclipse) {
  std::string kind = name(eclipse.type);
  kind.front() -= 'a' - 'A';
  return fmt::format("{} eclipse of the Moon, {}", kind,
                     almanac::date_text(eclipse.greatest, eclipse.calendar));
}

std::vector<std::pair<std::string, Instant>> contacts_of(const Eclipse& eclipse) {
  std::vector<std::pair<std::string, Instant>> all;
  const auto& contacts = eclipse.contacts;
  const auto add = [&](const char* name, const std::optional<Instant>& when) {
    if (when) all.emplace_back(name, *when);
  };
  add("P1", contacts.P1), add("U1", contacts.U1), add("U2", contacts.U2);
  add("greatest", eclipse.greatest);
  add("U3", contacts.U3), add("U4", contacts.U4), add("P4", contacts.P4);
  return all;
}

algebra::ByName<Instant> by_name(const Contacts& contacts) {
  Eclipse eclipse;
  eclipse.contacts = contacts;
  auto all = contacts_of(eclipse);
  std::erase_if(all, [](const auto& one) { return one.first == "greatest"; });
  return all;
}

std::optional<Eclipse> eclipse_of_day(const Instant& midnight, ShadowConvention convention) {
  constexpr double day_s = 86400;
  const auto first = almanac::later(midnight, -0.5);
  const auto all = eclipses_between(first, almanac::later(first, day_s), convention);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

}  // namespace coppermoon::eclipse
