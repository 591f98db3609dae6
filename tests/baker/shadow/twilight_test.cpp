// SPDX-License-Identifier: MIT
#include "shadow/twilight.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "atmosphere/presets.h"
#include "baker/shadow/airs_in_belts.h"
#include "photons/bending.h"
#include "shadow/by_quadrature.h"
#include "support/testing.h"

namespace coppermoon::shadow::twilight_test {

using atmosphere::Atmosphere;
using std::numbers::pi;

constexpr double sun_m = 1.5e11, moon_m = 3.8e8;

double ratio_at(const Atmosphere& air, double axis_distance_m, double nm, double depth_m = moon_m) {
  const std::vector<double> distances{axis_distance_m}, waves{nm};
  return twilight(air, {sun_m, {depth_m}}, waves, distances).ratio[0](0, 0);
}

atmosphere::Optics optics_at(const Atmosphere& air, double nm) {
  return atmosphere::sea_level_optics(algebra::nanometres(nm), air.molecules);
}

Atmosphere clear_air() {
  auto air = atmosphere::preset("molecular", algebra::degrees(0));
  air.earth = {};
  return air;
}

TEST(Twilight, WhereSightAndSunlightAreOneIsTheClosedForm) {
  // A sight that lies along the Sun's rays has the radiance E₀ P(0) / (4π) τ exp(−τ); in air of
  // scale height H, which makes τ = τ₀ exp(−h/H), that sums over the ring to
  // E/E₀ = P(0) / (4π) 2π R / z² H (1 − exp(−τ₀)).
  const auto air = clear_air();
  const double radius = air.earth.equatorial_radius_m, nm = 450;
  const auto at = [&](double z) {
    const double spread = 1 + z / sun_m;
    return ratio_at(air, 0, nm, z) * z * z / (spread * spread);
  };
  // The angle falls as 1/z: straight on through two depths to none.
  const double without_angle = 2 * at(1e9) - at(5e8);
  const double tau0 = atmosphere::product(photons::limb_path(0, radius, air.column, 0).amounts,
                                          atmosphere::spectra(air.column, optics_at(air, nm)));
  const double scale_height_m = 6.6e3;
  const double closed = 1.5 / (4 * pi) * 2 * pi * radius * scale_height_m * (1 - std::exp(-tau0));
  EXPECT_WITHIN_RELATIVE(without_angle, closed, 0.05,
                         "US 1976's scale height is 6.3 to 6.9 km where blue light passes");
}

/// Golden-ratio sequence in three dimensions: Roberts's.
glm::dvec3 spread_evenly(int i) {
  const double g = 1.22074408460575947536;
  const auto part = [](double x) { return x - std::floor(x); };
  return {part(0.5 + i / g), part(0.5 + i / (g * g)), part(0.5 + i / (g * g * g))};
}

struct Way {
  double optical_depth = 0, lowest_m = 1e9;
};

/// Step by step out of the air.
Way way_out(const Atmosphere& air, const atmosphere::Amounts& spectra, glm::dvec3 from,
            const glm::dvec3& direction) {
  constexpr double step_m = 12e3;
  Way way;
  for (from += direction * (step_m / 2);; from += direction * step_m) {
    const double altitude = glm::length(from) - air.earth.equatorial_radius_m;
    way.lowest_m = std::min(way.lowest_m, altitude);
    if (altitude < 0 || altitude > air.top_m()) return way;
    way.optical_depth +=
        step_m * atmosphere::product(atmosphere::profiles(air.column, altitude), spectra);
  }
}

/// What a point of the air scatters, of its dust, background and tropospheric aerosol too.
double scattered_at(const Atmosphere& air, const atmosphere::Amounts& spectra, double altitude_m,
                    double cosine) {
  const auto amounts = atmosphere::profiles(air.column, altitude_m);
  const auto phase = [&](double g) {
    return (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5);
  };
  using namespace atmosphere;
  return (0.75 * (1 + cosine * cosine) * amounts[atmosphere::air] * spectra[atmosphere::air] +
          phase(0.685) * amounts[stratosphere] * spectra[stratosphere] +
          0.947 * phase(0.698) * amounts[dust_layer] * spectra[dust_layer] +
          0.963 * phase(0.651) * amounts[troposphere] * spectra[troposphere]) /
         (4 * pi);
}

/// The light of each of many points spread through the air about the terminator, their ways to the
/// Sun and to the place stepped through: a sum over the volume, where the ring is one over sights.
double point_by_point(const Atmosphere& air, double axis_distance_m, double nm, double bottom_m = 0,
                      double top_m = 80e3) {
  constexpr int points = 40'000;
  constexpr double half_width_rad = 0.16;
  const auto optics = optics_at(air, nm);
  const auto spectra = atmosphere::spectra(air.column, optics);
  const glm::dvec3 place(axis_distance_m, 0, moon_m);
  double sum = 0;
  for (int i = 0; i < points; ++i) {
    const auto u = spread_evenly(i);
    const double altitude = bottom_m + (top_m - bottom_m) * u.x,
                 delta = half_width_rad * (2 * u.y - 1), psi = 2 * pi * u.z,
                 r = air.earth.equatorial_radius_m + altitude;
    const glm::dvec3 here = r * glm::dvec3(std::cos(delta) * std::cos(psi),
                                           std::cos(delta) * std::sin(psi), std::sin(delta));
    const double apart = glm::distance(here, place);
    const auto on = (place - here) / apart;
    const auto sun = way_out(air, spectra, here, {0, 0, -1}),
               moon = way_out(air, spectra, here, on);
    if (sun.lowest_m < 0 || moon.lowest_m < 0) continue;
    const double lowest = std::min({sun.lowest_m, moon.lowest_m, altitude});
    sum += r * r * std::cos(delta) * scattered_at(air, spectra, altitude, on.z) * on.z /
           (apart * apart) * std::exp(-sun.optical_depth - moon.optical_depth) *
           atmosphere::limb_filter(air.column, optics, lowest);
  }
  const double spread = 1 + moon_m / sun_m;
  return spread * spread * sum * (top_m - bottom_m) * 2 * half_width_rad * 2 * pi / points;
}

void expect_sum_over_all_points(double axis_m, double nm) {
  auto air = atmosphere::preset("undated", algebra::degrees(0));
  air.earth = {};
  EXPECT_WITHIN_RELATIVE(ratio_at(air, axis_m, nm), point_by_point(air, axis_m, nm), 0.015,
                         "40 000 points: 1 %; the ring's own quadrature: 0.5 %");
}

TEST(Twilight, IsTheSumOverAllPointsOfTheAir) {
  expect_sum_over_all_points(0, 420);
  expect_sum_over_all_points(5.5e6, 750);
}

TEST(TwilightThoroughly, IsTheSumOverAllPointsOfTheAir) {
  for (const double nm : {420., 600., 750.})
    for (const double axis_m : {0., 5.5e6}) expect_sum_over_all_points(axis_m, nm);
}

TEST(Twilight, OfDustInAirThatDimsNothingEndsInTheEarthsShadow) {
  // all that stops sunlight on its way to dust beyond the limb is the ground
  const Atmosphere air{.column = {.rayleigh = false, .dust_extinction_per_m = 1e-9}};
  const auto& dusty = air.column;
  for (const double axis_m : {0., 5.5e6})
    EXPECT_WITHIN_RELATIVE(
        ratio_at(air, axis_m, 600),
        point_by_point(air, axis_m, 600, dusty.dust_bottom_m, dusty.dust_top_m), 0.03,
        "40 000 points, and 48 a sight, whose ends in the shadow they round: 2 %; in sunlight "
        "the dust beyond would add a quarter");
}

TEST(Twilight, IsBlueWhereTheRefractedLightIsRed) {
  const auto air = clear_air();
  const std::vector<double> waves{450, 700}, distances{0};
  const auto bent = by_quadrature(air, {sun_m, {moon_m}}, waves, distances);
  EXPECT_LT(bent.ratio[0](0, 0), 1e-6);
  EXPECT_GT(bent.ratio[0](0, 1), 1e-4);
  EXPECT_GT(ratio_at(air, 0, 450), 0.5 * ratio_at(air, 0, 700));
}

TEST(Twilight, IsAllTheLightThereIsUnderAsh) {
  auto air = atmosphere::preset("undated", algebra::degrees(0));
  air.column.stratosphere = atmosphere::StratosphericAerosol::extreme;
  const std::vector<double> waves{450, 650}, distances{0};
  const Arrangement arrangement{sun_m, {moon_m}};
  const auto bent = by_quadrature(air, arrangement, waves, distances),
             scattered = twilight(air, arrangement, waves, distances);
  for (std::size_t w = 0; w < waves.size(); ++w)
    EXPECT_LT(bent.ratio[0](0, w), 0.01 * scattered.ratio[0](0, w));
}

TEST(Twilight, OfOneRegionAllAroundIsThatOfItsAir) {
  auto air = clear_air();
  const double alike = ratio_at(air, 2e6, 500);
  air.regions = {{algebra::degrees(0), algebra::degrees(360), air.column}};
  air.column.dust_extinction_per_m = 1e-3;
  // 24 directions instead of 12.
  EXPECT_WITHIN_RELATIVE(ratio_at(air, 2e6, 500), alike, 1e-3, "12 directions hold the ring");
}

TEST(Twilight, ComesFromTheRegionsOnItsOwnSide) {
  auto air = clear_air();
  auto dark = air.column;
  dark.cloud_cover = 1, dark.cloud_top_m = 30e3;
  air.regions = {{algebra::degrees(-90), algebra::degrees(90), dark}};
  const std::vector<double> distances{0, 4e6}, waves{450};
  const auto light = twilight(air, {sun_m, {moon_m}}, waves, distances);
  EXPECT_WITHIN_RELATIVE(light.ratio[0](0, 0), light.ratio[12](0, 0), 1e-9,
                         "the axis is one place");
  EXPECT_GT(std::abs(light.ratio[0](1, 0) - light.ratio[12](1, 0)), 0.1 * light.ratio[0](1, 0));
}

TEST(Twilight, InSeveralAirsIsThatInEach) {
  const auto airs = airs_in_belts(std::array{100., 500.}, std::array{0.01, 0.4, 1.});
  const std::vector<double> waves{400, 500, 600}, distances{0, 3e6};
  const Arrangement arrangement{sun_m, {moon_m, 1.01 * moon_m}};
  const auto together = twilight_in(airs, arrangement, waves, distances);
  ASSERT_EQ(together.size(), airs.size());
  for (std::size_t i = 0; i < airs.size(); ++i) {
    const auto alone = twilight(airs[i], arrangement, waves, distances);
    for (std::size_t g = 0; g < alone.ratio.size(); ++g)
      for (std::size_t d = 0; d < distances.size(); ++d)
        for (std::size_t w = 0; w < waves.size(); ++w)
          EXPECT_WITHIN_RELATIVE(together[i].ratio[g](d, w), alone.ratio[g](d, w), 1e-12,
                                 "rounding: all have some dust and some cloud")
              << i << ": sector " << g << ", " << distances[d] << " m, " << waves[w] << " nm";
  }
}

TEST(Twilight, RefusesAirsThatDifferInMoreThanAmounts) {
  auto airs = airs_in_belts(std::array{250.}, std::array{0.4, 1.});
  airs[1].belts.back().column.cloud_top_m = 5e3;
  const std::vector<double> waves{550}, distances{0};
  EXPECT_THROW(twilight_in(airs, {sun_m, {moon_m}}, waves, distances), algebra::Error);
}

TEST(Twilight, OfNoAirIsNothing) {
  EXPECT_EQ(ratio_at(atmosphere::preset("none", algebra::degrees(0)), 0, 500), 0);
}

TEST(AddTwilight, AgreesWithTheRingAtEveryPlaceAndWavelength) {
  auto air = atmosphere::preset("undated", algebra::degrees(0));
  std::vector<double> distances, waves;
  for (double d = 0; d < 6.4e6; d += 170e3) distances.push_back(d);
  for (double nm = 381; nm < 780; nm += 6) waves.push_back(nm);
  const Arrangement arrangement{sun_m, {moon_m}};
  const auto exact = twilight(air, arrangement, waves, distances);
  const double bent = 1e-7;
  auto light = exact;
  light.ratio[0] = algebra::Grid<double>(distances.size(), waves.size(), bent);
  add_twilight(light, air);
  for (std::size_t d = 0; d < distances.size(); ++d)
    for (std::size_t w = 0; w < waves.size(); ++w)
      EXPECT_WITHIN_RELATIVE(light.ratio[0](d, w) - bent, exact.ratio[0](d, w), 0.005,
                             "straight lines over 1000 km and 5 nm");
}

TEST(AddTwilight, IsTheSameInWhateverOrderWavelengthsStand) {
  const auto air = atmosphere::preset("undated", algebra::degrees(0));
  for (const auto& waves : {std::vector{610., 550., 465.}, std::vector{600., 450.}}) {
    auto light = darkness({sun_m, {moon_m}}, waves, std::vector{2e6}, 1);
    add_twilight(light, air);
    for (std::size_t w = 0; w < waves.size(); ++w)
      EXPECT_WITHIN_RELATIVE(light.ratio[0](0, w), ratio_at(air, 2e6, waves[w]), 0.005,
                             "straight lines over 1000 km and 5 nm");
  }
}

TEST(AddTwilight, OnPlanesOverTheMoonIsAsOnTheOneBetween) {
  const auto air = atmosphere::preset("undated", algebra::degrees(0));
  const std::vector<double> waves{450, 600}, distances{0, 1.3e6, 2.6e6, 4e6};
  const Arrangement planes{1.479e11, {3.83e8, 3.848e8, 3.866e8}};
  const auto exact = twilight(air, planes, waves, distances);
  auto light = darkness(planes, waves, distances, 1);
  add_twilight(light, air);
  for (std::size_t plane = 0; plane < planes.depths_m.size(); ++plane)
    for (std::size_t d = 0; d < distances.size(); ++d)
      for (std::size_t w = 0; w < waves.size(); ++w)
        EXPECT_WITHIN_RELATIVE(light.ratio[plane](d, w), exact.ratio[plane](d, w), 0.005,
                               "as the header says")
            << plane << " " << distances[d];
}

TEST(AddTwilight, RunsStraightBetweenSectors) {
  auto air = atmosphere::preset("undated", algebra::degrees(0));
  air.regions = {{algebra::degrees(20), algebra::degrees(140), air.column}};
  air.regions[0].column.dust_extinction_per_m = 1e-5;
  const std::vector<double> waves{550}, distances{2e6};
  const Arrangement plane{1.479e11, {3.83e8}};
  const auto exact = twilight(air, plane, waves, distances);
  auto light = darkness(plane, waves, distances, 2 * sectors_around);
  add_twilight(light, air);
  for (std::size_t s = 0; s < sectors_around; ++s) {
    const double here = exact.ratio[s](0, 0), next = exact.ratio[(s + 1) % sectors_around](0, 0);
    EXPECT_WITHIN_RELATIVE(light.ratio[2 * s](0, 0), here, 1e-12, "rounding") << s;
    EXPECT_WITHIN_RELATIVE(light.ratio[2 * s + 1](0, 0), (here + next) / 2, 1e-12, "rounding") << s;
  }
}

TEST(Starlight, IsThatOfTenthMagnitudeStars) {
  EXPECT_WITHIN_RELATIVE(starlight_ratio, 41253 * 100 / 4 * std::pow(10, -0.4 * (10 + 26.74)), 0.01,
                         "printed digits");
  RefractedLight light;
  light.ratio.emplace_back(1, 1);
  add_starlight(light);
  EXPECT_EQ(light.ratio[0](0, 0), starlight_ratio);
}

}  // namespace coppermoon::shadow::twilight_test
