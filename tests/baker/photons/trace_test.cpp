// SPDX-License-Identifier: MIT
#include "photons/trace.h"

#include <glm/geometric.hpp>

#include "photons/bending.h"
#include "support/testing.h"

namespace coppermoon::photons::trace_test {

using algebra::degrees;
using algebra::nanometres;
using atmosphere::Atmosphere;
using atmosphere::Column;
using atmosphere::Optics;
using atmosphere::sea_level_optics;

constexpr double arcminute = std::numbers::pi / 180 / 60;
const Atmosphere clear;
const Optics green = sea_level_optics(nanometres(550));

/// A ray along the shadow axis that meets the top of the air, b − R above the Earth at a position
/// angle.
Ray ray_in(double impact_height_m, double position_angle_rad = std::numbers::pi / 2) {
  const double b = clear.earth.equatorial_radius_m + impact_height_m;
  const Ray far{{b * std::sin(position_angle_rad), b * std::cos(position_angle_rad), -1e8},
                {0, 0, 1}};
  return entered(far, clear.top_radius_m()).value();
}

Traced traced(double impact_height_m, const Stepping& stepping = {},
              const Atmosphere& atmosphere = clear) {
  return trace(ray_in(impact_height_m), atmosphere, green, stepping).value();
}

double bending(const Traced& ray) {
  return std::atan2(std::hypot(ray.leaving.direction.x, ray.leaving.direction.y),
                    ray.leaving.direction.z);
}

LimbRay exact(double impact_height_m, const Atmosphere& atmosphere = clear) {
  return limb_ray(impact_height_m, atmosphere.earth.equatorial_radius_m, atmosphere.column, green)
      .value();
}

TEST(Entered, IsWhereALineMeetsASphereFirst) {
  const auto met = entered({{3, 0, -100}, {0, 0, 1}}, 5);
  ASSERT_TRUE(met);
  EXPECT_WITHIN(met->position_m.x, 3.0, 1e-13, "rounding");
  EXPECT_WITHIN(met->position_m.z, -4.0, 1e-13, "rounding");
  EXPECT_EQ(met->direction, glm::dvec3(0, 0, 1));
}

TEST(Entered, IsNothingForALineThatPassesByOrLeaves) {
  EXPECT_FALSE(entered({{6, 0, -100}, {0, 0, 1}}, 5));
  EXPECT_FALSE(entered({{5, 0, -100}, {0, 0, 1}}, 5));
  EXPECT_FALSE(entered({{3, 0, 100}, {0, 0, 1}}, 5));
}

// Figures computed elsewhere by a literal stepper at 1 km.
TEST(Trace, BendsAsAnotherLiteralStepper) {
  EXPECT_WITHIN(bending(traced(2500)) / arcminute, 60.71, 0.05, "how the last step is ended");
  EXPECT_WITHIN(bending(traced(5000)) / arcminute, 46.12, 0.05, "how the last step is ended");
}

TEST(Trace, FallsShortOfTheExactBendingByWhatItsDocumentationStates) {
  EXPECT_WITHIN(bending(traced(2500)) / exact(2500).bending_rad - 1, -0.0014, 1e-4,
                "stated to two digits");
  EXPECT_WITHIN(bending(traced(5000)) / exact(5000).bending_rad - 1, -0.0011, 1e-4,
                "stated to two digits");
}

// A difference of 10 m to one side takes the gradient 5 m further out: 5 m of a scale height of 8
// km.
TEST(Trace, KeepsTheErrorOfTheOneSidedDifferenceAsTheStepShrinks) {
  const auto fine = traced(5000, {.step_m = 20});
  EXPECT_WITHIN(bending(fine) / exact(5000).bending_rad - 1, -0.0006, 1e-4, "stated to one digit");
}

TEST(Trace, ConvergesToTheExactRayAsStepAndDifferenceShrink) {
  for (const double impact_height_m : {2500.0, 10e3, 20e3, 30e3}) {
    const auto fine = traced(impact_height_m, {.step_m = 20, .gradient_step_m = 0.1});
    EXPECT_WITHIN_RELATIVE(bending(fine), exact(impact_height_m).bending_rad, 1e-4,
                           "Euler's steps err by their length");
    EXPECT_WITHIN_RELATIVE(-std::log(fine.transmittance), exact(impact_height_m).optical_depth,
                           1e-4, "as above");
  }
}

// 981 in the paper; a figure computed elsewhere is 979.
TEST(Trace, TakesAsManyStepsAsThePaperReports) {
  constexpr int rays = 400;
  double steps = 0;
  for (int i = 0; i < rays; ++i) steps += traced(2000 + 40e3 * (i + 0.5) / rays).steps;
  EXPECT_WITHIN(steps / rays, 979.0, 15.0, "the paper does not say how b was spread");
}

TEST(Trace, WithoutAirIsAStraightLine) {
  const Atmosphere none{.column = {.refraction = false, .rayleigh = false}};
  const auto ray = traced(1000, {}, none);
  EXPECT_EQ(ray.leaving.direction, glm::dvec3(0, 0, 1));
  EXPECT_EQ(ray.leaving.position_m.x, ray_in(1000).position_m.x);
  EXPECT_EQ(ray.transmittance, 1);
}

TEST(Trace, EndsOnTheGround) {
  EXPECT_FALSE(trace(ray_in(1000), clear, green, {}));
  EXPECT_FALSE(trace(ray_in(-1e6), clear, green, {}));
  EXPECT_TRUE(trace(ray_in(2000), clear, green, {}));
}

// Bouguer: n r sin i is the same all along. Outside the air n = 1.
TEST(Trace, KeepsBouguersInvariant) {
  for (const double impact_height_m : {2000.0, 5000.0, 10e3, 20e3, 40e3}) {
    const auto& leaving = traced(impact_height_m).leaving;
    const double b = glm::length(glm::cross(leaving.position_m, leaving.direction));
    EXPECT_WITHIN(b - clear.earth.equatorial_radius_m, impact_height_m, 25.0,
                  "Euler's steps of 1 km: 0.1 % of the bending over 600 km of path");
  }
}

TEST(Trace, StaysInThePlaneOfTheRay) {
  const auto ray = trace(ray_in(5000, 0.7), clear, green, {.gradient_step_m = 0.1}).value();
  const glm::dvec3 normal(std::cos(0.7), -std::sin(0.7), 0);
  EXPECT_WITHIN(glm::dot(ray.leaving.direction, normal), 0.0, 1e-6,
                "one-sided differences lean by half of 0.1 m over a scale height of 8 km");
  EXPECT_WITHIN_RELATIVE(bending(ray), bending(traced(5000, {.gradient_step_m = 0.1})), 1e-4,
                         "as above");
  EXPECT_WITHIN(glm::length(ray.leaving.direction), 1.0, 1e-15, "rounding");
}

TEST(Trace, DimsAsTheExactRay) {
  const Atmosphere dusty{.column = {.ozone_du = 300, .dust_extinction_per_m = 4.7e-6}};
  for (const double impact_height_m : {2500.0, 5000.0, 10e3, 16e3, 20e3, 30e3})
    EXPECT_WITHIN_RELATIVE(std::log(traced(impact_height_m, {}, dusty).transmittance),
                           std::log(exact(impact_height_m, dusty).transmittance), 0.01,
                           "1 km steps across the faces of the dust, 0.14 % of bending");
}

// The position angle runs from Y (north) through X (east).
TEST(Trace, LooksUpTheRegionBeneathIt) {
  const Atmosphere half{.regions = {{degrees(45), degrees(135), {.dust_extinction_per_m = 1e-5}}}};
  const auto through = [&](double position_angle_deg) {
    return trace(ray_in(10e3, in_radians(degrees(position_angle_deg))), half, green, {})
        .value()
        .transmittance;
  };
  const double free = through(0);
  EXPECT_WITHIN(through(90) / free, std::exp(-1e-5 * 208e3), 0.01,
                "208 km of dust along a straight line; the bent one has 1 % less or more");
  EXPECT_WITHIN_RELATIVE(through(180), free, 0.01, "one-sided differences");
  EXPECT_WITHIN_RELATIVE(through(270), free, 0.01, "one-sided differences");
}

TEST(Trace, DimsByAllThatStandsInTheAir) {
  Atmosphere full;
  full.column = {.density = atmosphere::Density::us_1976,
                 .ozone_du = 345,
                 .ozone_path = atmosphere::OzonePath::bent,
                 .tropospheric_optical_depth = 0.07,
                 .stratosphere = atmosphere::StratosphericAerosol::high,
                 .cloud_top_m = 10e3,
                 .cloud_cover = 0.7};
  const auto high = [&](double impact_height_m) {
    const Ray far{{clear.earth.equatorial_radius_m + impact_height_m, 0, -1e8}, {0, 0, 1}};
    return trace(entered(far, full.top_radius_m()).value(), full, green, {}).value();
  };
  for (const double impact_height_m : {3000., 8000., 12e3, 18e3, 25e3, 35e3, 50e3, 70e3})
    EXPECT_WITHIN(high(impact_height_m).transmittance, exact(impact_height_m, full).transmittance,
                  0.012 * exact(impact_height_m, full).transmittance *
                      (1 + exact(impact_height_m, full).optical_depth),
                  "1 km steps and 0.14 % of bending: 1 % of optical depth");
}

// Over the pole the ground curves as a²/b, over the equator of an equinox as a: the osculating
// sphere's ray is the ellipsoid's.
TEST(Trace, OverAnEllipsoidIsTheRayOverTheSphereThatFitsTheLimb) {
  const Atmosphere oblate{.earth = atmosphere::ellipsoid(0.2)};
  const double top_m = oblate.top_radius_m();
  for (const double angle : {0., 0.6, std::numbers::pi / 2}) {
    const auto limb = atmosphere::limb_at(oblate.earth, angle);
    for (const double impact_height_m : {3e3, 8e3, 20e3}) {
      const double b = limb.radius_m + impact_height_m;
      const Ray far{{b * std::sin(angle), b * std::cos(angle), -1e8}, {0, 0, 1}};
      const auto stepped =
          trace(entered(far, top_m).value(), oblate, green, {.step_m = 100, .gradient_step_m = 0.1})
              .value();
      const auto fitted =
          limb_ray(impact_height_m, limb.curvature_radius_m, oblate.column, green).value();
      EXPECT_WITHIN_RELATIVE(bending(stepped), fitted.bending_rad, 1e-3,
                             "100 m steps; 3 km of path bring 1e-3 of curvature with them");
      EXPECT_WITHIN_RELATIVE(-std::log(stepped.transmittance), fitted.optical_depth, 1e-3,
                             "as above");
    }
  }
}

TEST(Trace, RefusesStepsOutsideItsRange) {
  for (const double step_m : {0.0, 0.99, 100'001.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(trace(ray_in(5000), clear, green, {.step_m = step_m}), algebra::Error) << step_m;
}

}  // namespace coppermoon::photons::trace_test
