// SPDX-License-Identifier: MIT
#include "eclipse/shadow_axis.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "almanac/instant.h"
#include "support/testing.h"

namespace coppermoon::eclipse::shadow_axis_test {

using algebra::in_degrees;
using algebra::in_metres;

const glm::dvec3 celestial_pole{0, 0, 1};

/// The Sun at the autumn equinox's place: the shadow lies towards the spring equinox, +X.
ShadowAxis simple_axis() { return shadow_axis({-1.5e11, 0, 0}, celestial_pole); }

TEST(ShadowAxis, PositionAnglesRunFromNorthThroughEast) {
  const ShadowAxis axis = simple_axis();  // from +X on the sky celestial east is +Y
  EXPECT_WITHIN(in_degrees(place_in_shadow(axis, {3.8e8, 0, 1e6}).position_angle), 0, 1e-9,
                "exact");
  EXPECT_WITHIN(in_degrees(place_in_shadow(axis, {3.8e8, 1e6, 0}).position_angle), 90, 1e-9,
                "exact");
  EXPECT_WITHIN(in_degrees(place_in_shadow(axis, {3.8e8, 0, -1e6}).position_angle), 180, 1e-9,
                "exact");
  EXPECT_WITHIN(in_degrees(place_in_shadow(axis, {3.8e8, -1e6, 0}).position_angle), 270, 1e-9,
                "exact");
}

TEST(ShadowAxis, DepthIsPositiveAwayFromTheSun) {
  const ShadowPlace behind = place_in_shadow(simple_axis(), {3.8e8, 3e6, 4e6});
  EXPECT_WITHIN(in_metres(behind.depth), 3.8e8, 1e-3, "rounding");
  EXPECT_WITHIN(in_metres(behind.axis_distance), 5e6, 1e-3, "3, 4, 5");
  EXPECT_LT(in_metres(place_in_shadow(simple_axis(), {-3.8e8, 0, 0}).depth), 0);
}

TEST(ShadowAxis, TheFrameIsRightHanded) {
  const glm::dmat3 m = shadow_axis({1e11, 7e10, 3e10}, celestial_pole).shadow_from_gcrs;
  EXPECT_WITHIN(glm::determinant(m), 1, 1e-12, "rounding; a mirror gives −1");
}

TEST(ShadowAxis, TheSunsDeclinationIsItsOwnNotTheShadows) {
  const ShadowAxis axis = shadow_axis({1e11, 0, 1e11}, celestial_pole);
  EXPECT_WITHIN(in_degrees(axis.sun_declination), 45, 1e-9, "closed form");
}

TEST(ShadowAxis, OnTheNorthSideTheSunOfTheSkyGivesTheSameFrame) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2008-02-21T03:26:05Z"),
                                   almanac::LunarTheory::moon98);
  const ShadowAxis axis = shadow_axis(sky);
  EXPECT_WITHIN(in_degrees(axis.sun_declination),
                in_degrees(almanac::equatorial_place(sky, sky.sun_m).declination), 1e-9,
                "rounding");
  EXPECT_WITHIN(
      glm::length(axis.shadow_from_gcrs * glm::normalize(sky.sun_m) - glm::dvec3(0, 0, -1)), 0,
      1e-12, "rounding");
}

/// Shadow's coordinates [m]: celestial east, celestial north, away from the Sun.
glm::dvec3 coordinates_m(const ShadowPlace& place) {
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
  ShadowAxis axis_ = shadow_axis(sky_);
  glm::dvec3 centre_m_ = coordinates_m(place_in_shadow(axis_, sky_.moon_m));
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

}  // namespace coppermoon::eclipse::shadow_axis_test
