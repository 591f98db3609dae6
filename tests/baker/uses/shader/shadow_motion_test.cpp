// SPDX-License-Identifier: MIT
#include "uses/shader/shadow_motion.h"

#include <glm/geometric.hpp>

#include "almanac/ephemeris.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "support/testing.h"

namespace coppermoon::uses::shadow_motion_test {

eclipse::Eclipse eclipse_of(const char* day) {
  return eclipse::nearest_eclipse(almanac::instant_from_utc(day),
                                  eclipse::ShadowConvention::danjon);
}

/// Value of a power series.
template <class Value>
Value at(const std::vector<Value>& coefficients, double t) {
  auto sum = coefficients.back();
  for (std::size_t i = coefficients.size() - 1; i-- > 0;) sum = sum * t + coefficients[i];
  return sum;
}

/// Place of the Moon's ground in the shadow [lunar radii]: east, north, depth.
glm::dvec3 by_the_almanac(const almanac::Instant& when, const glm::dvec3& ground) {
  const auto sky = almanac::sky_at(when);
  const auto place = eclipse::place_of_ground(eclipse::shadow_axis(sky), sky, ground);
  const double angle_rad = in_radians(place.position_angle),
               radius_m = in_metres(almanac::lunar_radius),
               distance = in_metres(place.axis_distance) / radius_m;
  return {distance * std::sin(angle_rad), distance * std::cos(angle_rad),
          in_metres(place.depth) / radius_m};
}

TEST(ShadowMotion, IsThatOfTheAlmanacThroughoutAnEclipse) {
  for (const char* day : {"2018-07-27", "2021-11-19", "1963-12-30"}) {
    const auto eclipse = eclipse_of(day);
    const auto motion = shadow_motion(eclipse);
    double nearest = 1e9, farthest = 0;
    for (double t = -1; t <= 1; t += 0.125) {
      const auto when = almanac::later(eclipse.greatest, t * motion.half_s);
      for (const glm::dvec3 ground : {glm::dvec3{1, 0, 0}, {0.6, 0.8, 0}, {0.6, 0, -0.8}}) {
        const auto exact = by_the_almanac(when, ground);
        for (int k = 0; k < 3; ++k) {
          const auto axis = static_cast<std::size_t>(k);
          const double series =
              at(motion.centre[axis], t) + glm::dot(at(motion.axes[axis], t), ground);
          EXPECT_WITHIN(series, exact[k], 0.1 / 1737.4, "lunar radii: 0.1 km") << day << ", " << t;
        }
      }
      const double depth = at(motion.centre[2], t);
      nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
    }
    EXPECT_WITHIN(motion.nearest, nearest, 0.02, "lunar radii: the Moon's way to the next node");
    EXPECT_WITHIN(motion.farthest, farthest, 0.02, "lunar radii: the same");
  }
}

TEST(ShadowMotion, LastsFromTenMinutesBeforeTheFirstContactToTenAfterTheLast) {
  const auto eclipse = eclipse_of("2018-07-27");
  const auto contacts = eclipse::contacts_of(eclipse);
  const double before_s = almanac::seconds_between(contacts.front().second, eclipse.greatest),
               after_s = almanac::seconds_between(eclipse.greatest, contacts.back().second);
  EXPECT_EQ(shadow_motion(eclipse).half_s, 600 + std::max(before_s, after_s));
}

}  // namespace coppermoon::uses::shadow_motion_test
