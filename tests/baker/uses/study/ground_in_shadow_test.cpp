// SPDX-License-Identifier: MIT
#include "uses/study/ground_in_shadow.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "almanac/instant.h"
#include "support/within.h"

namespace coppermoon::uses {
namespace {

/// Shadow's coordinates [m]: celestial east, celestial north, away from the Sun.
glm::dvec3 coordinates_m(const eclipse::ShadowPlace& place) {
  const double away = algebra::in_metres(place.axis_distance),
               angle = algebra::in_radians(place.position_angle);
  return {away * std::sin(angle), away * std::cos(angle), algebra::in_metres(place.depth)};
}

class GroundInShadow : public testing::Test {
 protected:
  glm::dvec3 place_m(const glm::dvec3& ground) const {
    return coordinates_m(place_of_ground(axis_, sky_, ground));
  }

  almanac::SkyState sky_ = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:40:00Z"));
  eclipse::ShadowAxis axis_ = eclipse::shadow_axis(sky_);
  glm::dvec3 centre_m_ = coordinates_m(eclipse::place_in_shadow(axis_, sky_.moon_m));
};

TEST_F(GroundInShadow, IsALunarRadiusFromTheMoonsCentreEveryWay) {
  for (const glm::dvec3 ground : {glm::dvec3(1, 0, 0), {0, 1, 0}, {0, 0, 1}, {0.6, 0, -0.8}}) {
    const auto one = place_m(ground), other = place_m(-ground);
    EXPECT_WITHIN(glm::distance(one, centre_m_), 1.7374e6, 1e-3, "rounding of 4e8 m");
    EXPECT_WITHIN(glm::distance((one + other) / 2., centre_m_), 0, 1e-3, "the same");
  }
}

TEST_F(GroundInShadow, OfTheNearSidesMiddleIsNearestToTheEarth) {
  const auto near = place_m(almanac::selenographic_direction(sky_.sub_earth));
  const auto expected = centre_m_ * (1 - 1.7374e6 / glm::length(centre_m_));
  EXPECT_WITHIN(glm::distance(near, expected), 0, 100,
                "the sub-Earth point's light time: 1.3 s of libration, some 1e-5 radians");
}

}  // namespace
}  // namespace coppermoon::uses
