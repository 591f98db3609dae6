// SPDX-License-Identifier: MIT
#include "eclipse/feature.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "algebra/error.h"
#include "eclipse/lunation.h"
#include "eclipse/zero_between.h"

namespace coppermoon::eclipse {
namespace {

using almanac::Instant;
using almanac::SelenographicPoint;

void require_on_moon(const SelenographicPoint& place) {
  algebra::require_within("lunar latitude [deg]", algebra::in_degrees(place.latitude), -90, 90);
  algebra::require_within("lunar longitude [deg]", algebra::in_degrees(place.longitude), -360, 360);
}

/// Geocentric position of a lunar feature, in GCRS axes. The Moon's orientation is corrected for light time.
glm::dvec3 position_m(const glm::dvec3& direction, const glm::dvec3& moon_m, const Instant& when) {
  const double light_time_s = glm::length(moon_m) / almanac::speed_of_light_m_per_s;
  const glm::dmat3 selenographic_from_gcrs =
      almanac::selenographic_from_gcrs(almanac::later(when, -light_time_s));
  return moon_m + algebra::in_metres(almanac::lunar_radius) *
                      (glm::transpose(selenographic_from_gcrs) * direction);
}

/// Angle from the umbra's edge to a lunar feature, as seen from the Earth [rad]; negative inside the umbra.
double outside_umbra_rad(const Lunation& lunation, const glm::dvec3& direction, double seconds) {
  const Sighting moon = sighting_at(lunation, seconds);
  const ShadowPlace place = place_in_shadow(
      moon.axis, position_m(direction, moon.moon_m, almanac::later(lunation.middle, seconds)));
  const auto radii = shadow_radii(ShadowConvention::danjon_oblate, moon.axis, place);
  return std::atan2(algebra::in_metres(place.axis_distance), algebra::in_metres(place.depth)) -
         algebra::in_radians(radii.umbra);
}

/// Finds the minimum of a unimodal function f between a and b [s], to within 0.1 s, by golden-section search.
template <class Function>
double least_between(Function f, double a, double b) {
  constexpr double share = std::numbers::phi - 1;
  double c = b - share * (b - a), d = a + share * (b - a);
  for (double fc = f(c), fd = f(d); b - a > 0.1;) {
    if (fc < fd) {
      b = d;
      d = c;
      fd = fc;
      c = b - share * (b - a);
      fc = f(c);
    } else {
      a = c;
      c = d;
      fc = fd;
      d = a + share * (b - a);
      fd = f(d);
    }
  }
  return (a + b) / 2;
}

}  // namespace

FeatureTimes feature_times(const Eclipse& eclipse, const SelenographicPoint& place,
                           almanac::LunarTheory theory) {
  require_on_moon(place);
  const Lunation lunation = lunation_around(eclipse.greatest, theory);
  const glm::dvec3 direction = almanac::selenographic_direction(place);
  const auto outside = [&](double s) { return outside_umbra_rad(lunation, direction, s); };
  const double P1 = almanac::seconds_between(eclipse.greatest, *eclipse.contacts.P1),
               P4 = almanac::seconds_between(eclipse.greatest, *eclipse.contacts.P4);
  const double deepest = least_between(outside, P1, P4);
  if (outside(deepest) >= 0) return {};
  return {almanac::later(eclipse.greatest, zero_between(outside, P1, deepest)),
          almanac::later(eclipse.greatest, zero_between(outside, deepest, P4))};
}

}  // namespace coppermoon::eclipse
