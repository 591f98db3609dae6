// SPDX-License-Identifier: MIT
#include "atmosphere/figure.h"

#include <glm/geometric.hpp>

#include "support/testing.h"

namespace coppermoon::atmosphere::figure_test {

constexpr double a = earth_equatorial_radius_m, b = a * (1 - earth_flattening);
constexpr double degree = std::numbers::pi / 180, solstice = 23.44 * degree;

Limb limb(double sun_declination_rad, double position_angle_deg) {
  return limb_at(ellipsoid(sun_declination_rad), position_angle_deg * degree);
}

/// A place over the ground of latitude φ, from the axis of the Earth: geodetic, in closed form.
glm::dvec3 over_the_ground_m(double latitude, double longitude, double height_m) {
  const double e_squared = earth_flattening * (2 - earth_flattening), sine = std::sin(latitude);
  const double n = a / std::sqrt(1 - e_squared * sine * sine);
  return {(n + height_m) * std::cos(latitude) * std::cos(longitude),
          (n + height_m) * std::cos(latitude) * std::sin(longitude),
          (n * (1 - e_squared) + height_m) * sine};
}

/// The same in the shadow frame: the Earth's axis stands on Y and leans by the declination to −Z.
glm::dvec3 in_shadow_frame(const glm::dvec3& p, double declination) {
  return {p.x, p.z * std::cos(declination) + p.y * std::sin(declination),
          p.y * std::cos(declination) - p.z * std::sin(declination)};
}

TEST(Limb, RunsFromTheEquatorialToThePolarRadius) {
  EXPECT_WITHIN(limb(0, 90).radius_m, 6378137, 1e-3, "definition");
  EXPECT_WITHIN(limb(0, 0).radius_m, 6356752, 2, "WGS 84's polar radius; 1/298.257 is rounded");
}

TEST(Limb, AtTheSolsticeThePoleIsTippedIn) {
  const double cosine = std::cos(solstice);
  EXPECT_WITHIN(6378137 - limb(solstice, 0).radius_m, (6378137 - 6356752) * cosine * cosine, 20,
                "to first order in the flattening; the second is 1/300 of 18 km");
}

// The shadow of an ellipsoid is an ellipse of semi-axes a and √(a² sin² δ + b² cos² δ).
TEST(Limb, IsAnEllipseAtEveryPositionAngle) {
  for (double declination : {-solstice, 0.1, solstice}) {
    const double minor = std::hypot(a * std::sin(declination), b * std::cos(declination));
    for (int angle = 0; angle < 360; angle += 15) {
      const double reference =
          1 / std::hypot(std::sin(angle * degree) / a, std::cos(angle * degree) / minor);
      EXPECT_WITHIN(limb(declination, angle).radius_m, reference, 1e-6, "rounding") << angle;
    }
  }
}

TEST(Limb, WithThePoleTowardsTheSunIsTheEquator) {
  for (int angle = 0; angle < 360; angle += 30)
    EXPECT_WITHIN(limb(90 * degree, angle).radius_m, a, 1e-6, "rounding") << angle;
}

TEST(Limb, IsCurvedAsTheMeridianAtThePoleAndAsTheEquatorAtTheEquator) {
  EXPECT_WITHIN(limb(0, 0).curvature_radius_m, a * a / b, 1e-6,
                "the vertex of an ellipse: a²/b in closed form");
  EXPECT_WITHIN(limb(0, 180).curvature_radius_m, a * a / b, 1e-6, "the other pole");
  EXPECT_WITHIN(limb(0, 90).curvature_radius_m, a, 1e-6, "the equator is a circle");
}

TEST(Limb, WithThePoleTowardsTheSunIsCurvedAsTheMeridianAtTheEquator) {
  for (int angle = 0; angle < 360; angle += 45)
    EXPECT_WITHIN(limb(90 * degree, angle).curvature_radius_m, b * b / a, 1e-6,
                  "the flank of an ellipse: b²/a in closed form")
        << angle;
}

// A sphere of the radius of curvature R fits the ground along the light: at s from the place of
// tangency light is s²/2R over it.
TEST(Limb, TheGroundFallsAwayFromALightRayByItsCurvature) {
  const Figure figure = ellipsoid(solstice);
  const double angle = 30 * degree, reach_m = 20e3;
  const glm::dvec3 outward{std::sin(angle), std::cos(angle), 0};
  const auto [radius_m, curvature_m] = limb_at(figure, angle);
  double lowest_m = 1e9, lowest_at_m = 0;  // the ray's place of tangency
  for (double z = -30e3; z <= 30e3; z += 10)
    if (const double h = altitude_m(figure, radius_m * outward + glm::dvec3(0, 0, z));
        h < lowest_m) {
      lowest_m = h;
      lowest_at_m = z;
    }
  EXPECT_WITHIN(lowest_m, 0, 1e-3, "a ray at the limb's radius grazes the ground; 10 m steps");
  for (double side : {-reach_m, reach_m})
    EXPECT_WITHIN(altitude_m(figure, radius_m * outward + glm::dvec3(0, 0, lowest_at_m + side)),
                  reach_m * reach_m / (2 * curvature_m), 0.05,
                  "31 m: the place of tangency to 5 m is 0.02 m, the next order 1e-5 of it");
}

TEST(Limb, OfASphereIsTheSphere) {
  const Figure sphere{.equatorial_radius_m = 6.4e6, .polar_radius_m = 6.4e6};
  EXPECT_TRUE(sphere.sphere());
  EXPECT_FALSE(ellipsoid(0).sphere());
  for (int angle = 0; angle < 360; angle += 45) {
    EXPECT_EQ(limb_at(sphere, angle * degree).radius_m, 6.4e6);
    EXPECT_EQ(limb_at(sphere, angle * degree).curvature_radius_m, 6.4e6);
  }
}

TEST(Altitude, IsNoneOnTheGround) {
  for (double declination : {-solstice, 0.0, solstice})
    for (int latitude = -90; latitude <= 90; latitude += 15) {
      const auto place = over_the_ground_m(latitude * degree, 1, 0);
      EXPECT_WITHIN(altitude_m(ellipsoid(declination), in_shadow_frame(place, declination)), 0,
                    1e-6, "rounding")
          << latitude;
    }
}

TEST(Altitude, IsTheGeodeticHeightInTheAir) {
  for (int latitude = -90; latitude <= 90; latitude += 15)
    for (double height_m : {10e3, 86e3}) {
      const auto place = over_the_ground_m(latitude * degree, 4, height_m);
      EXPECT_WITHIN(altitude_m(ellipsoid(solstice), in_shadow_frame(place, solstice)), height_m,
                    0.5, "along the radius, 11.5′ from the vertical at most: 5.6e-6 of 86 km")
          << latitude;
    }
}

TEST(Altitude, OverASphereIsTheDistanceLessTheRadius) {
  const Figure sphere{.equatorial_radius_m = 6.4e6, .polar_radius_m = 6.4e6};
  EXPECT_EQ(altitude_m(sphere, {0, 6.41e6, 0}), 1e4);
}

}  // namespace coppermoon::atmosphere::figure_test
