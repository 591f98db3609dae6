// SPDX-License-Identifier: MIT
#include "shadow/by_quadrature.h"

#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "atmosphere/presets.h"
#include "photons/solar_disc.h"
#include "support/within.h"

namespace coppermoon::shadow {
namespace {

const Arrangement february_2008{1.479e11, {3.83e8}};

std::vector<double> up_to(double last_m, double step_m) {
  std::vector<double> list;
  for (double x = 0; x <= last_m; x += step_m) list.push_back(x);
  return list;
}

atmosphere::Atmosphere straight_and_clear() {
  atmosphere::Atmosphere air;
  air.column.refraction = air.column.rayleigh = false;
  return air;
}

TEST(ByQuadrature, WithoutAirIsTheSunSeenThroughTheShellWhereItStood) {
  // Nothing bends, nothing dims: light through the ring is what the larger disc hides and the
  // smaller does not.
  const auto air = straight_and_clear();
  const auto distances = up_to(8.6e6, 1e5);
  const std::vector<double> waves{550};
  const auto light = by_quadrature(air, february_2008, waves, distances, 1200);
  for (std::size_t d = 0; d < distances.size(); ++d) {
    const double z = february_2008.depths_m[0], sun = february_2008.sun_distance_m;
    const double ring = covered_part(distances[d], z, sun, air.top_radius_m()) -
                        covered_part(distances[d], z, sun, air.earth.equatorial_radius_m);
    EXPECT_WITHIN(light.ratio[0](d, 0), ring, 2e-6,
                  "1e-4 of a ring that is at most 1.4e-2 of the disc");
  }
}

/// ∫ E/E₀ dA over the plane is what enters the ring: (1 + z/D)² π (b₁² − b₀²), whatever bends on
/// the way.
TEST(ByQuadrature, KeepsTheEnergyThatEntersTheRing) {
  atmosphere::Atmosphere air;
  air.column.rayleigh = false;
  const std::vector<double> waves{450, 700};
  const auto distances = up_to(8.8e6, 1e4);
  const auto light = by_quadrature(air, february_2008, waves, distances);
  const double spread = 1 + february_2008.depths_m[0] / february_2008.sun_distance_m;
  for (std::size_t w = 0; w < waves.size(); ++w) {
    double flux = 0;
    for (std::size_t d = 0; d < distances.size(); ++d)
      flux += light.ratio[0](d, w) * 2 * std::numbers::pi * distances[d] * 1e4;
    const auto optics = atmosphere::sea_level_optics(algebra::nanometres(waves[w]));
    const double b0 = air.earth.equatorial_radius_m * (1 + optics.refractivity),
                 b1 = air.top_radius_m();
    const double entering = spread * spread * std::numbers::pi * (b1 * b1 - b0 * b0);
    EXPECT_WITHIN_RELATIVE(flux, entering, 2e-4, "10 km between the places summed over");
  }
}

void expect_accuracy(const atmosphere::Atmosphere& air, bool limb_darkening) {
  const std::vector<double> waves{450, 550, 650};
  const auto distances = up_to(8e6, 1e5);
  auto arrangement = february_2008;
  arrangement.limb_darkening = limb_darkening;
  const auto usual = by_quadrature(air, arrangement, waves, distances);
  const auto fine = by_quadrature(air, arrangement, waves, distances, 6000);
  for (std::size_t s = 0; s < usual.sectors; s += 3)
    for (std::size_t d = 0; d < distances.size(); ++d)
      for (std::size_t w = 0; w < waves.size(); ++w) {
        const double exact = fine.ratio[s](d, w);
        const bool deep = distances[d] <= 4.5e6;
        EXPECT_WITHIN(usual.ratio[s](d, w), exact,
                      deep ? exact * (waves[w] < 500 ? 1e-3 : 3e-4) : 1e-5, "as the header says")
            << distances[d] << " m, " << waves[w] << " nm";
      }
}

TEST(ByQuadrature, ReachesItsAccuracyAtTheDefaultNumberOfRays) { expect_accuracy({}, false); }

TEST(ByQuadrature, ReachesItsAccuracyWithEveryTerm) {
  expect_accuracy(atmosphere::preset("standard", algebra::degrees(10)), true);
}

TEST(ByQuadrature, IsSoundAtTheExtremes) {
  atmosphere::Atmosphere thick;
  thick.column.dust_extinction_per_m = 0.01;
  const std::vector<double> waves{380, 780};
  const auto distances = up_to(9e6, 3e5);
  for (const auto& air : {atmosphere::Atmosphere{}, thick})
    for (const double sun : {4.6e10, 4.4e11})
      for (const double depth : {1.01e8, 9.9e8}) {
        const auto light = by_quadrature(air, {sun, {depth}}, waves, distances, 40);
        for (const auto value : light.ratio[0].values())
          EXPECT_TRUE(std::isfinite(value) && value >= 0) << value;
      }
}

TEST(ByQuadrature, IsFiniteAtEveryWavelengthOfAScene) {
  // Rays that graze a break of the air to rounding once came out as no number.
  std::vector<double> waves;
  for (double nm = 380; nm <= 780; nm += 0.5) waves.push_back(nm);
  const std::vector<double> distances{1e6, 4e6};
  const auto light = by_quadrature({}, february_2008, waves, distances, 60);
  for (const auto value : light.ratio[0].values()) EXPECT_TRUE(std::isfinite(value) && value > 0);
}

TEST(ByQuadrature, OfABareEarthIsNothing) {
  atmosphere::Atmosphere none;
  none.column.density = atmosphere::Density::none;
  const std::vector<double> waves{550}, distances{0, 5e6};
  const auto light = by_quadrature(none, february_2008, waves, distances);
  for (const auto value : light.ratio[0].values()) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace coppermoon::shadow
