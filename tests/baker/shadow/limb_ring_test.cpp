// SPDX-License-Identifier: MIT
#include "shadow/limb_ring.h"

#include "atmosphere/presets.h"
#include "photons/bending.h"
#include "photons/limb_darkening.h"
#include "photons/solar_disc.h"
#include "shadow/by_quadrature.h"
#include "support/testing.h"

namespace coppermoon::shadow::limb_ring_test {

using algebra::degrees;
using algebra::metres;
using std::numbers::pi;

constexpr double moon_m = 384400e3, sun_m = 149597870.7e3;
const Arrangement darkened{sun_m, {moon_m}, true}, uniform{sun_m, {moon_m}, false};
const std::vector<double> waves{420, 550, 650};

eclipse::ShadowPlace place(double axis_distance_m, algebra::Angle position_angle = {}) {
  return {metres(axis_distance_m), position_angle, metres(moon_m)};
}

atmosphere::Atmosphere on_a_sphere(const char* name) {
  auto air = atmosphere::preset(name, degrees(0));
  air.earth = {};
  return air;
}

atmosphere::Atmosphere transparent() {
  auto air = on_a_sphere("molecular");
  air.column.rayleigh = false;
  return air;
}

/// What a ring of radiance 1 between two impact parameters makes of sunlight, for each radian and
/// metre of b: E/E₀ = (d/(R☉ D))² / π ∫∫ L b db dψ, d the Sun's distance from the place.
double irradiance_factor(const LimbRing& ring) {
  const double D = ring.distance_m();
  return std::pow((sun_m + moon_m) / (photons::solar_radius_m * D), 2) / pi;
}

/// The ring's radiance summed over its solid angle, over unshaded sunlight.
std::vector<double> irradiance(const LimbRing& ring, int angles, int heights) {
  const auto [lowest, highest] = ring.extent();
  const double step = (highest - lowest) / heights;
  std::vector<double> sum(waves.size()), here(waves.size());
  for (int i = 0; i < angles; ++i)
    for (int j = 0; j < heights; ++j) {
      const double b = lowest + (j + 0.5) * step;
      ring.radiance(2 * pi * (i + 0.5) / angles, b, here);
      for (std::size_t w = 0; w < here.size(); ++w)
        sum[w] += irradiance_factor(ring) * here[w] * b * step * 2 * pi / angles;
    }
  return sum;
}

struct Where {
  const char* name;
  double axis_distance_m;
};

class RingFrom : public testing::TestWithParam<Where> {};

// Radiance over solid angle is irradiance, whichever way it is summed: the quadrature sums arcs of
// the Sun's disc by where they land.
TEST_P(RingFrom, GivesTheLightThatTheQuadratureHas) {
  const auto air = atmosphere::preset("undated", degrees(12));
  constexpr std::size_t sector = sectors_around / 8;
  const std::vector<double> there{GetParam().axis_distance_m};
  const auto light = by_quadrature(air, darkened, waves, there, {.rays = 1000});
  const LimbRing ring(air, darkened, place(there[0], degrees(45)), waves);
  const auto sum = irradiance(ring, 240, 1200);
  for (std::size_t w = 0; w < waves.size(); ++w)
    EXPECT_WITHIN_RELATIVE(sum[w], light.ratio[sector](0, w), 3e-3,
                           "rays along the vertical, and D² for z²: 1e-4; the edges' steps: 1e-3")
        << waves[w] << " nm";
}

INSTANTIATE_TEST_SUITE_P(LimbRing, RingFrom,
                         testing::Values(Where{"TheAxis", 0}, Where{"HalfWay", 2300e3},
                                         Where{"NearTheEdge", 4400e3}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(LimbRing, IsTheSameAllAroundFromTheAxisOfASphere) {
  const LimbRing ring(on_a_sphere("undated"), darkened, place(0), waves);
  const auto [lowest, highest] = ring.extent();
  std::vector<double> first(waves.size()), other(waves.size());
  double lit = 0;
  for (double b = lowest; b < highest; b += 100) {
    ring.radiance(0, b, first);
    for (const double angle : {0.4, 2.3, 5.9}) {
      ring.radiance(angle, b, other);
      for (std::size_t w = 0; w < waves.size(); ++w)
        EXPECT_WITHIN_RELATIVE(other[w], first[w], 1e-5,
                               "rounding of 1e-16 rad, of 5e-3 that the Sun's radius is; at its "
                               "edge the root of it");
    }
    lit += first[1];
  }
  EXPECT_GT(lit, 0);
}

TEST(LimbRing, IsBrightestWhereTheSunStandsAndMirroredAboutIt) {
  const LimbRing ring(on_a_sphere("undated"), darkened, place(1000e3, degrees(70)), waves);
  const auto extent = ring.extent();
  const double lowest = extent.lowest_m, highest = extent.highest_m;
  const auto brightness = [&](double from_sun_deg) {
    std::vector<double> here(waves.size());
    double sum = 0;
    for (double b = lowest; b < highest; b += 20) {
      ring.radiance((70 + from_sun_deg) * pi / 180, b, here);
      sum += here[1];
    }
    return sum;
  };
  for (const double angle : {20., 60., 130.})
    EXPECT_WITHIN_RELATIVE(brightness(angle), brightness(-angle), 1e-3, "one step of 20 m");
  EXPECT_GT(brightness(0), brightness(60));
  EXPECT_GT(brightness(60), brightness(120));
  EXPECT_GT(brightness(120), brightness(180));
}

/// So far out on the axis that the air shows all of the Sun: from the Moon's distance its lower edge is
/// behind the ground.
constexpr double far_m = 7e8;
const eclipse::ShadowPlace far_out{metres(0), {}, metres(far_m)};

/// Where the exact ray that comes there with an impact parameter passes the Sun's centre [solar
/// radii]: above 0 on the limb's own side.
double off_centre(const atmosphere::Atmosphere& air, double b) {
  const double R = air.earth.equatorial_radius_m;
  const auto optics = optics_of(air, std::vector<double>{550}).front();
  const auto ray = photons::limb_ray(b - R, R, air.column, optics);
  return (b + sun_m * std::sin(std::asin(b / far_m) - ray->bending_rad)) / photons::solar_radius_m;
}

/// The impact parameter of the ray that passes there: bisection.
double impact_m(const atmosphere::Atmosphere& air, double solar_radii) {
  double low = air.earth.equatorial_radius_m + 2500, high = low + 80e3;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (off_centre(air, middle) < solar_radii ? low : high) = middle;
  }
  return low;
}

double green(const LimbRing& ring, double b) {
  double value = NAN;
  ring.radiance(1, b, {&value, 1});
  return value;
}

// Radiance is conserved: seen through transparent air the Sun is as bright as it is.
TEST(LimbRing, OfTransparentAirIsTheSunAsBrightAsItIs) {
  const auto air = transparent();
  const std::vector<double> wave{550};
  const LimbRing ring(air, darkened, far_out, wave);
  for (const double radii : {-0.9, -0.5, 0., 0.5, 0.9})
    EXPECT_WITHIN_RELATIVE(
        green(ring, impact_m(air, radii)),
        photons::limb_darkening(algebra::nanometres(550), std::sqrt(1 - radii * radii)), 1e-4,
        "straight lines between 1000 rays: the second differences of as many, 1e-5 of 1e-3 rad")
        << radii;
}

TEST(LimbRing, OfTransparentAirHasTheSunsEdgesWhereTheExactRayPoints) {
  const auto air = transparent();
  const std::vector<double> wave{550};
  const LimbRing ring(air, uniform, far_out, wave);
  const double inner = impact_m(air, -1), outer = impact_m(air, 1);
  constexpr double near_m = 1;
  EXPECT_EQ(green(ring, inner - near_m), 0);
  EXPECT_EQ(green(ring, inner + near_m), 1);
  EXPECT_EQ(green(ring, outer - near_m), 1);
  EXPECT_EQ(green(ring, outer + near_m), 0);
}

// The ring's area is the light, in closed form: E/E₀ = (d/D)² (b₂² − b₁²)/R☉².
TEST(LimbRing, OfTransparentAirHasTheQuadraturesLightInItsArea) {
  const auto air = transparent();
  const double inner = impact_m(air, -1), outer = impact_m(air, 1);
  const auto light = by_quadrature(air, {sun_m, {far_m}, false}, std::vector<double>{550},
                                   std::vector<double>{0}, {.rays = 1000});
  const double spread = (sun_m + far_m) / far_m / photons::solar_radius_m;
  EXPECT_WITHIN_RELATIVE(light.ratio[0](0, 0), spread * spread * (outer * outer - inner * inner),
                         1e-3, "1.5e-4 of the quadrature, 5e-5 that the planes are taken parallel");
}

TEST(LimbRing, ExtentHoldsAllOfItsLight) {
  for (const double gamma : {0., 2000e3, 4400e3}) {
    const LimbRing ring(atmosphere::preset("undated", degrees(0)), darkened,
                        place(gamma, degrees(30)), waves);
    const auto [lowest, highest] = ring.extent();
    std::vector<double> here(waves.size());
    for (double angle = 0; angle < 2 * pi; angle += 0.05)
      for (const double beyond : {1., 500., 5e3, 20e3})
        for (const double b : {lowest - beyond, highest + beyond}) {
          ring.radiance(angle, b, here);
          for (const double value : here) EXPECT_EQ(value, 0) << gamma << ", " << angle;
        }
  }
}

TEST(LimbRing, IsDarkerOverADustyHemisphereAlone) {
  auto air = atmosphere::preset("undated", degrees(0));
  auto dust = air.column;
  dust.dust_extinction_per_m = 1e-5;
  const LimbRing clean(air, darkened, place(0), waves);
  air.regions = {*between_latitudes(degrees(-90), degrees(0), degrees(0), dust)};
  const LimbRing half(air, darkened, place(0), waves);
  std::vector<double> with(waves.size()), without(waves.size());
  for (const double angle : {0.5, 2.6}) {
    const double b = atmosphere::limb_at(air.earth, angle).radius_m + 5e3;
    clean.radiance(angle, b, without);
    half.radiance(angle, b, with);
    ASSERT_GT(without[1], 0);
    if (angle < pi / 2)
      EXPECT_WITHIN_RELATIVE(with[1], without[1], 1e-12, "the same air");
    else
      EXPECT_LT(with[1], 0.5 * without[1]);
  }
}

TEST(LimbRing, WithoutAirIsRefused) {
  EXPECT_THROW(LimbRing(on_a_sphere("none"), darkened, place(0), waves), algebra::Error);
  EXPECT_THROW(LimbRing(on_a_sphere("undated"), {1e9, {}}, place(0), waves), algebra::Error);
}

TEST(LimbRing, OfAirThatDoesNotBendLightHasNone) {
  auto air = on_a_sphere("undated");
  air.column.refraction = false;
  const auto [lowest, highest] = LimbRing(air, darkened, place(0), waves).extent();
  EXPECT_EQ(lowest, highest);
}

}  // namespace coppermoon::shadow::limb_ring_test
