// SPDX-License-Identifier: MIT
#include "shadow/by_photons.h"

#include <tbb/global_control.h>

#include "atmosphere/presets.h"
#include "baker/algebra/chi_squared.h"
#include "baker/shadow/ring_means.h"
#include "support/testing.h"

namespace coppermoon::shadow::by_photons_test {

const Arrangement february_2008{1.479e11, {3.83e8}};
const std::vector<double> waves{500, 580, 680};

PhotonSettings settings_of(std::uint64_t photons, double ring_m) {
  PhotonSettings settings;
  settings.photons = photons;
  settings.literal = true;
  settings.ring_width_m = ring_m;
  return settings;
}

TEST(ByPhotonsThoroughly, AgreeWithTheQuadratureInEveryRing) {
  // chi² over 20 rings of 400 km, from 400 km outwards: nearer the axis too few land for a normal
  // law. The bounds are the 0.0005 and 0.9995 quantiles for 20 degrees of freedom: one true run in
  // a thousand fails.
  constexpr double ring_m = 400e3, lowest = 5.40, highest = 47.50;
  constexpr std::size_t first = 1, rings = 20;
  const auto light = in_rings({}, february_2008, waves, settings_of(240'000, ring_m));
  const auto exact = ring_means({}, february_2008, waves, ring_m, first + rings);
  for (std::size_t w = 0; w < waves.size(); ++w) {
    double chi_squared = 0;
    for (std::size_t r = first; r < first + rings; ++r) {
      const double off = (light.ratio[0](r, w) - exact(r, w)) / light.standard_error[0](r, w);
      chi_squared += off * off;
    }
    EXPECT_GT(chi_squared, lowest) << waves[w] << " nm";
    EXPECT_LT(chi_squared, highest) << waves[w] << " nm";
  }
}

TEST(ByPhotonsThoroughly, CarryTheMeanThatTheQuadratureCarries) {
  // One ring takes all; t-test of the mean, two-sided: 3.29 standard errors, one true run in a
  // thousand fails.
  constexpr double ring_m = 2000e3;
  const auto light = in_rings({}, february_2008, waves, settings_of(120'000, ring_m));
  const auto exact = ring_means({}, february_2008, waves, ring_m, light.axis_distances_m.size());
  for (std::size_t w = 0; w < waves.size(); ++w) {
    double flux = 0, expected = 0, variance = 0;
    for (std::size_t r = 0; r < light.axis_distances_m.size(); ++r) {
      const double area = light.axis_distances_m[r];  // over 2π times the width
      flux += area * light.ratio[0](r, w);
      expected += area * exact(r, w);
      variance += std::pow(area * light.standard_error[0](r, w), 2);
    }
    EXPECT_LT(std::abs(flux - expected), 3.29 * std::sqrt(variance)) << waves[w] << " nm";
    EXPECT_LT(std::sqrt(variance), 0.02 * expected) << "a test that sees 6 %";
  }
}

TEST(ByPhotons, AreTheSamePhotonsWhateverTheNumberOfThreads) {
  for (const bool literal : {true, false}) {
    auto settings = settings_of(literal ? 5'000 : 300'000, 100e3);
    settings.literal = literal;
    std::vector<RefractedLight> runs;
    for (const std::size_t threads : {1U, 2U, 3U}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      runs.push_back(by_photons({}, february_2008, waves, settings));
    }
    for (std::size_t i = 0; i < runs[0].ratio[0].values().size(); ++i)
      for (const auto& run : {runs[1], runs[2]}) {
        ASSERT_EQ(runs[0].ratio[0].values()[i], run.ratio[0].values()[i]);
        ASSERT_EQ(runs[0].standard_error[0].values()[i], run.standard_error[0].values()[i]);
      }
  }
}

TEST(ByPhotons, DifferWithTheSeed) {
  auto settings = settings_of(2'000, 1000e3);
  const auto one = by_photons({}, february_2008, waves, settings);
  settings.seed = 2;
  const auto two = by_photons({}, february_2008, waves, settings);
  EXPECT_NE(one.ratio[0](4, 1), two.ratio[0](4, 1));
}

TEST(ByPhotonsThoroughly, OfSymmetricAirFillAllSectorsAlike) {
  // chi² over 8 sectors of one wide ring: 7 degrees of freedom about their own mean; one true run
  // in a thousand fails.
  auto settings = settings_of(60'000, 2000e3);
  settings.sectors = 8;
  const std::vector<double> wave{650};
  const auto light = in_rings({}, february_2008, wave, settings);
  for (std::size_t ring : {2U, 3U}) {
    double mean = 0, chi_squared = 0;
    for (std::size_t s = 0; s < 8; ++s) mean += light.ratio[s](ring, 0) / 8;
    for (std::size_t s = 0; s < 8; ++s)
      chi_squared +=
          std::pow((light.ratio[s](ring, 0) - mean) / light.standard_error[s](ring, 0), 2);
    EXPECT_GT(chi_squared, 0.30);
    EXPECT_LT(chi_squared, 26.02);
  }
}

TEST(ByPhotons, SeeAnOpaqueRegionOnItsOwnSide) {
  // Dust of optical depth beyond 10 in the eastern half: in the outer shadow light comes from the
  // near limb.
  atmosphere::Atmosphere air;
  atmosphere::Column dusty;
  dusty.dust_extinction_per_m = 1e-2;
  dusty.dust_bottom_m = 0;
  dusty.dust_top_m = 42e3;
  air.regions.push_back({algebra::degrees(0), algebra::degrees(180), dusty});
  auto settings = settings_of(10'000, 1000e3);
  settings.sectors = 4;
  const std::vector<double> wave{650};
  const auto light = in_rings(air, february_2008, wave, settings);
  constexpr std::size_t outer = 6, east = 1, west = 3;
  EXPECT_LT(light.ratio[east](outer, 0), 1e-40);  // e^−100 and less
  EXPECT_GT(light.ratio[west](outer, 0), 5 * light.standard_error[west](outer, 0));
}

/// Every term at once: an oblate Earth of a northern winter, limb darkening, ozone, aerosol and
/// cloud, and a plume over the south.
atmosphere::Atmosphere everything(bool regions) {
  auto air = atmosphere::preset("undated", algebra::degrees(-20));
  auto plume = air.column;
  plume.stratosphere = atmosphere::StratosphericAerosol::moderate;
  plume.dust_extinction_per_m = 2e-6;
  if (regions)
    air.regions = {*between_latitudes(algebra::degrees(-90), algebra::degrees(-10),
                                      algebra::degrees(-20), plume)};
  return air;
}

const Arrangement darkened{1.479e11, {3.83e8}, true};

/// How far apart two lights of one wavelength are, over all rings and sectors with enough photons
/// to be normal, in units of what their errors allow.
struct Apart {
  double chi_squared = 0, worst = 0;
  int cells = 0;
};

Apart apart(const RefractedLight& a, const RefractedLight& b, std::size_t wave,
            std::size_t first_ring, std::size_t rings) {
  Apart sum;
  for (std::size_t s = 0; s < a.sectors; ++s)
    for (std::size_t r = first_ring; r < first_ring + rings; ++r, ++sum.cells) {
      const double error = std::hypot(a.standard_error[s](r, wave), b.standard_error[s](r, wave));
      const double off = std::abs(a.ratio[s](r, wave) - b.ratio[s](r, wave)) / error;
      sum.chi_squared += off * off;
      sum.worst = std::max(sum.worst, off);
    }
  return sum;
}

/// The 0.0005 and 0.9995 quantiles of chi² by Wilson & Hilferty: one true run in a thousand fails.
ChiSquaredBounds chi_squared_of(int freedom) {
  const double third = 2. / (9 * freedom);
  return {freedom * std::pow(1 - third - 3.29 * std::sqrt(third), 3),
          freedom * std::pow(1 - third + 3.29 * std::sqrt(third), 3)};
}

/// Each wavelength by itself: those of one photon err together.
///
/// Given  blocks  that the errors are known from: t² of ν freedoms has the mean ν/(ν − 2)
void expect_agreement(const RefractedLight& a, const RefractedLight& b, double blocks,
                      std::size_t first_ring, std::size_t rings) {
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const auto found = apart(a, b, w, first_ring, rings);
    const auto bounds = chi_squared_of(found.cells);
    const double chi_squared = found.chi_squared * (blocks - 3) / (blocks - 1);
    EXPECT_GT(chi_squared, bounds.lowest) << waves[w] << " nm";
    EXPECT_LT(chi_squared, bounds.highest) << waves[w] << " nm";
  }
}

/// The quadrature's mean over each ring and sector that photons gather in.
RefractedLight gathered_by_quadrature(const atmosphere::Atmosphere& air, double ring_m,
                                      std::size_t rings) {
  constexpr std::size_t places = 8;
  std::vector<double> distances;
  for (std::size_t i = 0; i < rings * places; ++i)
    distances.push_back((static_cast<double>(i) + 0.5) / places * ring_m);
  const auto fine = by_quadrature(air, darkened, waves, distances, {.rays = 1000});
  RefractedLight light = fine;
  light.standard_error = light.ratio;
  for (std::size_t s = 0; s < fine.sectors; ++s) {
    light.ratio[s] = light.standard_error[s] = algebra::Grid<double>(rings, waves.size());
    for (std::size_t r = 0; r < rings; ++r)
      for (std::size_t w = 0; w < waves.size(); ++w) {
        double sum = 0, area = 0;
        for (std::size_t d = r * places; d < (r + 1) * places; ++d) {
          // a sector's mean over its width, from its middle and its neighbours'
          const auto at = [&](std::size_t sector) {
            return fine.ratio[sector % fine.sectors](d, w);
          };
          sum += distances[d] * (22 * at(s) + at(s + 1) + at(s + fine.sectors - 1)) / 24;
          area += distances[d];
        }
        light.ratio[s](r, w) = sum / area;
      }
  }
  return light;
}

/// In the air of every term, over 17 rings of 500 km.
const RefractedLight& exactly(bool regions) {
  static const auto with = gathered_by_quadrature(everything(true), 500e3, 17),
                    without = gathered_by_quadrature(everything(false), 500e3, 17);
  return regions ? with : without;
}

PhotonSettings by_the_table(std::uint64_t photons, double ring_m) {
  auto settings = settings_of(photons, ring_m);
  settings.literal = false;
  settings.sectors = sectors_around;
  return settings;
}

TEST(ByPhotons, WithEveryTermAgreeWithTheQuadrature) {
  const auto air = everything(false);
  const auto photons = in_rings(air, darkened, waves, by_the_table(6'000'000, 500e3));
  expect_agreement(photons, exactly(false), 5860, 1, 15);
}

TEST(ByPhotons, WithEveryTermAndARegionAgreeWithTheQuadrature) {
  const auto air = everything(true);
  auto settings = by_the_table(6'000'000, 500e3);
  settings.seed = 2;
  const auto photons = in_rings(air, darkened, waves, settings);
  expect_agreement(photons, exactly(true), 5860, 1, 15);
}

TEST(ByPhotonsThoroughly, WithEveryTermAndARegionAreTheSameTracedEachAndByTheTable) {
  const auto air = everything(true);
  auto each = settings_of(30'000, 1000e3), table = by_the_table(1'000'000, 1000e3);
  each.sectors = table.sectors = 4;
  each.seed = 3;
  expect_agreement(in_rings(air, darkened, waves, each), in_rings(air, darkened, waves, table), 30,
                   1, 7);
}

TEST(ByPhotons, OfAirWithoutItsDustAreSeenToDifferFromTheQuadrature) {
  // The check checked: 2e-6 m⁻¹ over 5 km missing from the plume, and the agreement must fail.
  auto lighter = everything(true);
  for (auto& region : lighter.regions) region.column.dust_extinction_per_m = 0;
  const auto photons = in_rings(lighter, darkened, waves, by_the_table(2'000'000, 500e3));
  const auto& exact = exactly(true);
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const auto found = apart(photons, exact, w, 1, 15);
    EXPECT_GT(found.chi_squared, 2 * chi_squared_of(found.cells).highest) << waves[w] << " nm";
  }
}

TEST(ByPhotons, OfHalfTheLightAreSeenToDifferFromTheQuadrature) {
  auto photons = in_rings(everything(false), darkened, waves, by_the_table(200'000, 500e3));
  for (auto& grid : photons.ratio)
    for (double& value : grid.values()) value /= 2;
  const auto& exact = exactly(false);
  for (std::size_t w = 0; w < waves.size(); ++w) {
    const auto found = apart(photons, exact, w, 1, 15);
    EXPECT_GT(found.chi_squared, 2 * chi_squared_of(found.cells).highest) << waves[w] << " nm";
  }
}

TEST(ByPhotons, RefuseOneSectorForAirThatDiffersByRegion) {
  atmosphere::Atmosphere air;
  air.regions.push_back({algebra::degrees(0), algebra::degrees(90), {}});
  EXPECT_THROW(by_photons(air, february_2008, waves, settings_of(10, 1e5)), algebra::Error);
}

TEST(ByPhotons, RefuseSettingsOutsideTheirRange) {
  EXPECT_THROW(by_photons({}, february_2008, waves, settings_of(0, 1e5)), algebra::Error);
  EXPECT_THROW(by_photons({}, february_2008, waves, settings_of(10, -1)), algebra::Error);
  auto settings = settings_of(10, 1e5);
  settings.stepping.step_m = 0;
  EXPECT_THROW(by_photons({}, february_2008, waves, settings), algebra::Error);
  settings = settings_of(10, 1e5);
  settings.enough = StoppingRule{{1}, 0.01, 0, 1e6};
  EXPECT_THROW(by_photons({}, february_2008, waves, settings), algebra::Error) << "three waves";
}

TEST(Smoothed, KeepsAConstantAndShrinksTheError) {
  RefractedLight light{february_2008,
                       {550},
                       {},
                       1,
                       {algebra::Grid<double>(100, 1, 0.5)},
                       {algebra::Grid<double>(100, 1, 0.1)}};
  for (int i = 0; i < 100; ++i) light.axis_distances_m.push_back((i + 0.5) * 50e3);
  const auto smooth = smoothed(light, 150e3);
  for (const double value : smooth.ratio[0].values())
    EXPECT_WITHIN_RELATIVE(value, 0.5, 1e-14, "weights of sum 1");
  // The mean of independent rings under a Gaussian of σ = 3 rings: 1/√(2 √π σ) of each one's error.
  EXPECT_WITHIN_RELATIVE(smooth.standard_error[0](60, 0),
                         0.1 / std::sqrt(2 * std::sqrt(std::numbers::pi) * 3), 0.01,
                         "closed form for weights that do not grow with the axis distance");
}

}  // namespace coppermoon::shadow::by_photons_test
