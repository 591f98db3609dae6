// SPDX-License-Identifier: MIT
#include "shadow/photon_sums.h"

#include "algebra/interpolation.h"
#include "algebra/quadrature.h"
#include "algebra/random.h"
#include "shadow/by_photons.h"
#include "shadow/lookup.h"
#include "support/testing.h"

namespace coppermoon::shadow::photon_sums_test {

const Arrangement february_2008{1.479e11, {3.83e8}};
const std::vector<double> waves{500, 580, 680};

PhotonSettings settings_of(std::uint64_t photons) {
  PhotonSettings settings;
  settings.photons = photons;
  settings.ring_width_m = 100e3;
  settings.key = "a test";
  return settings;
}

PhotonSums traced_blocks(BlockRange blocks) {
  auto settings = settings_of(1);
  settings.blocks = blocks;
  return traced({}, february_2008, waves, settings);
}

/// Cell by cell, the light and its error.
void expect_same(const RefractedLight& a, const RefractedLight& b) {
  EXPECT_EQ(a.photons, b.photons);
  for (std::size_t i = 0; i < a.ratio[0].values().size(); ++i) {
    EXPECT_WITHIN_RELATIVE(a.ratio[0].values()[i], b.ratio[0].values()[i], 1e-12,
                           "rounding of sums in another order");
    EXPECT_WITHIN_RELATIVE(a.standard_error[0].values()[i], b.standard_error[0].values()[i], 1e-9,
                           "the same, in a difference of sums");
  }
}

TEST(PhotonSums, OfEightShardsAreThoseOfOneRun) {
  const auto all = blocks_of(100 * photons_a_block);
  const auto whole = traced_blocks(all);
  auto together = traced_blocks(shard(all, 8, 8));
  for (const std::uint64_t part : {3U, 1U, 2U, 7U, 5U, 4U, 6U})
    together = merged(std::move(together), traced_blocks(shard(all, part, 8)));
  EXPECT_EQ(together.done, whole.done);
  expect_same(estimated(together), estimated(whole));
}

TEST(PhotonSums, AreAddedToWithoutTracingAnyTwice) {
  auto before = merged(traced_blocks({0, 10}), traced_blocks({30, 41}));
  const auto more = traced({}, february_2008, waves, settings_of(50 * photons_a_block), &before);
  EXPECT_EQ(more.done, (std::vector<BlockRange>{{0, 50}}));
  expect_same(estimated(more), estimated(traced_blocks({0, 50})));
}

TEST(PhotonSums, AlreadyThereAreLeftAlone) {
  const auto before = traced_blocks({0, 20});
  const auto same = traced({}, february_2008, waves, settings_of(5 * photons_a_block), &before);
  EXPECT_EQ(same.done, before.done);
  EXPECT_EQ(same.sum[0](20, 1), before.sum[0](20, 1));
}

TEST(PhotonSums, OfTheSameBlocksAreRefused) {
  EXPECT_THROW(merged(traced_blocks({0, 10}), traced_blocks({9, 12})), algebra::Error);
}

TEST(PhotonSums, OfDifferentThingsAreRefused) {
  const auto one = traced_blocks({0, 1});
  auto other = traced_blocks({1, 2});
  other.key = "another";
  EXPECT_THROW(merged(one, other), algebra::Error);
  other = traced_blocks({1, 2});
  other.wavelengths_nm[0] += 1;
  EXPECT_THROW(merged(one, other), algebra::Error);
}

TEST(PhotonSums, HaveTheMeanOfTheirBlocksAndTheErrorOfIt) {
  // By hand: eight blocks in one ring of 1 km, seven bring 0 and one 8 · 1024 · 1e6 π m².
  PhotonSums sums;
  sums.arrangement = {1e11, {1e8}};
  sums.wavelengths_nm = {550};
  sums.ring_width_m = 1e3;
  sums.rings = 1;
  sums.done = {{0, 8}};
  const double light = 8 * 1024 * 1e6 * std::acos(-1.);
  sums.sum = {algebra::Grid<double>(1, 1, light)};
  sums.sum_of_squares = {algebra::Grid<double>(1, 1, light * light)};
  const auto found = means_over_rings(sums);
  const double spread = 1.001 * 1.001;
  EXPECT_WITHIN_RELATIVE(found.ratio[0](0, 0), spread, 1e-14, "the mean is 1 · 1024 · area");
  EXPECT_WITHIN_RELATIVE(found.standard_error[0](0, 0), spread, 1e-14,
                         "variance (64 − 8)/7 = 8, over 8 blocks: 1");
}

/// Sums whose means over rings are given, each with a noise that is a part of it.
PhotonSums sums_of(const std::vector<double>& means, double width_m, double relative_noise) {
  constexpr double blocks = 101;
  PhotonSums sums;
  sums.arrangement = {1e30, {1e8}};
  sums.wavelengths_nm = {420};
  sums.ring_width_m = width_m;
  sums.rings = means.size();
  sums.done = {{0, 101}};
  sums.sum = sums.sum_of_squares = {algebra::Grid<double>(means.size(), 1)};
  for (std::size_t r = 0; r < means.size(); ++r) {
    const double area_m2 = std::numbers::pi * width_m * width_m * (2 * static_cast<double>(r) + 1),
                 of_a_block = means[r] * area_m2 * photons_a_block;
    sums.sum[0](r, 0) = blocks * of_a_block;
    sums.sum_of_squares[0](r, 0) =
        blocks * of_a_block * of_a_block * (1 + (blocks - 1) * relative_noise * relative_noise);
  }
  return sums;
}

using Light = std::function<double(double axis_distance_m)>;

/// Its means over rings, by area.
std::vector<double> means_of(const Light& light, double width_m, std::size_t rings) {
  std::vector<double> means(rings);
  for (std::size_t r = 0; r < rings; ++r) {
    const double middle_m = (static_cast<double>(r) + 0.5) * width_m;
    for (const auto& [node, weight] : algebra::gauss_legendre(30)) {
      const double at_m = middle_m + node * width_m / 2;
      means[r] += weight / 2 * at_m / middle_m * light(at_m);
    }
  }
  return means;
}

/// Of 20 rings the largest relative error at the middles, and between them as a reader finds it; the
/// last five left out, for no rings follow.
struct Worst {
  double at_middles = 0, between = 0, in_standard_errors = 0;
};

Worst worst_of(const Light& light, double width_m, double from_m = 0) {
  constexpr std::size_t rings = 20;
  const auto found = estimated(sums_of(means_of(light, width_m, rings), width_m, 1e-6));
  const BetweenPlaces between(found);
  std::vector<double> errors(found.standard_error[0].values().begin(),
                             found.standard_error[0].values().end());
  Worst worst;
  for (std::size_t r = 0; r < 15; ++r) {
    const double at_m = found.axis_distances_m[r];
    if (at_m < from_m) continue;
    worst.at_middles = std::max(worst.at_middles, std::abs(found.ratio[0](r, 0) / light(at_m) - 1));
    for (int k = -4; k <= 4; ++k) {
      const double here_m = at_m + k * width_m / 8;
      double value = NAN;
      between.read(0, 0, here_m, {&value, 1});
      const double off = value - light(here_m);
      worst.between = std::max(worst.between, std::abs(off / light(here_m)));
      worst.in_standard_errors =
          std::max(worst.in_standard_errors,
                   std::abs(off) / algebra::interpolated(found.axis_distances_m, errors, here_m));
    }
  }
  return worst;
}

TEST(RingMiddles, HaveTheLightOfAnExponential) {
  for (const double width_m : {5e3, 50e3, 200e3})
    for (const double length_m : {100e3, 200e3, 500e3, -300e3, 1000e3}) {
      const auto light = [=](double m) { return 1e-9 * std::exp(m / length_m); };
      // the axis is a kink of it
      const auto worst = worst_of(light, width_m, 4 * width_m);
      const double tolerance = std::abs(width_m / length_m) <= 0.5 ? 2e-5 : 2e-3;
      EXPECT_LT(worst.at_middles, tolerance) << width_m << " " << length_m;
      EXPECT_LT(worst.between, tolerance) << width_m << " " << length_m;
    }
}

TEST(RingMiddles, HaveTheLightOfABellAboutTheAxis) {
  for (const double width_m : {50e3, 200e3}) {
    const auto bell = [=](double m) { return 1e-9 * std::exp(std::pow(m / (8 * width_m), 2)); };
    EXPECT_LT(worst_of(bell, width_m).between, 2e-4) << "of a parabola's logarithm";
  }
}

TEST(RingMiddles, ErrNoMoreThanTheyTellWhereLightHasAKink) {
  for (double kink_m = 450e3; kink_m < 550e3; kink_m += 7e3) {
    const auto light = [=](double m) {
      return 1e-6 * std::exp((m - kink_m) / (m < kink_m ? 100e3 : 400e3));
    };
    const auto worst = worst_of(light, 50e3, 200e3);
    EXPECT_LT(worst.in_standard_errors, 5) << kink_m;
    EXPECT_GT(worst.between, 5e-3) << "a test of kinks";
  }
}

TEST(RingMiddles, KeepTheLightOfEachRing) {
  // the mean over each ring of what is read between middles is the photons' own
  const auto light = [](double m) { return 1e-6 * std::exp(2 * std::cos(m / 300e3)); };
  const double width_m = 50e3;
  const auto means = means_of(light, width_m, 40);
  const auto found = estimated(sums_of(means, width_m, 1e-6));
  const BetweenPlaces between(found);
  const auto read = [&](double at_m) {
    double value = NAN;
    between.read(0, 0, at_m, {&value, 1});
    return value;
  };
  const auto again = means_of(read, width_m, 40);
  for (std::size_t r = 0; r < 38; ++r)
    EXPECT_WITHIN_RELATIVE(again[r], means[r], 2e-4,
                           "3/640 of the fourth difference, of kinks of the cubics")
        << r;
}

TEST(RingMiddles, MakeNoiseGrowByNoMoreThanTheyTell) {
  // a hundred draws of noise of 5 % on an exponential of 50 km rings
  constexpr double noise = 0.05;
  constexpr int draws = 100;
  const double width_m = 50e3;
  const auto light = [](double m) { return 1e-6 * std::exp(m / 250e3); };
  const auto means = means_of(light, width_m, 40);
  algebra::Random random(1, 0);
  double found_squares = 0, told_squares = 0, chi_squared = 0, sum = 0;
  int count = 0;
  for (int k = 0; k < draws; ++k) {
    auto drawn = means;
    for (double& mean : drawn) mean *= 1 + noise * std::sqrt(12.) * (random.uniform() - 0.5);
    const auto found = estimated(sums_of(drawn, width_m, noise));
    for (std::size_t r = 3; r < 37; ++r, ++count) {
      const double exact = light(found.axis_distances_m[r]), off = found.ratio[0](r, 0) / exact - 1;
      sum += off;
      found_squares += off * off;
      told_squares += std::pow(found.noise[0](r, 0) / exact, 2);
      chi_squared += std::pow(off * exact / found.standard_error[0](r, 0), 2);
    }
  }
  const double found = std::sqrt(found_squares / count), told = std::sqrt(told_squares / count);
  EXPECT_WITHIN_RELATIVE(found, 1.09 * noise, 0.05, "3400 draws: 1.3 %, four times that");
  EXPECT_WITHIN_RELATIVE(told, found, 0.05, "the same");
  EXPECT_WITHIN(sum / count, 0, 4 * noise / std::sqrt(count), "four standard errors: no bias");
  EXPECT_LT(chi_squared / count, 1.05) << "errors that are told are not too small";
  EXPECT_GT(chi_squared / count, 0.6) << "nor much too large";
}

TEST(RingMiddles, KeepWhatIsEmptyOrLostInNoise) {
  const std::vector<double> means{1e-6, 2e-6, 0, 3e-6, 4e-6, 1e-30, 5e-6, 5e-6, 0, 0, 1e-6};
  const auto found = estimated(sums_of(means, 50e3, 0.01));
  for (std::size_t r = 0; r < means.size(); ++r) {
    EXPECT_GE(found.ratio[0](r, 0), 0.9 * means[r]) << r;
    EXPECT_LE(found.ratio[0](r, 0), 1.1 * means[r]) << r;
    EXPECT_GE(found.standard_error[0](r, 0), 0.0099 * means[r]) << r;
  }
  EXPECT_EQ(found.ratio[0](2, 0), 0);
  const auto noisy = sums_of(means, 50e3, 0.4);
  const auto kept = estimated(noisy);
  const auto exact = means_over_rings(noisy);
  for (std::size_t r = 0; r < means.size(); ++r) {
    EXPECT_EQ(kept.ratio[0](r, 0), exact.ratio[0](r, 0));
    EXPECT_EQ(kept.standard_error[0](r, 0), exact.standard_error[0](r, 0));
  }
}

TEST(RingMiddles, OfRingsTooWideDoNotKeepPhotonsGoing) {
  const auto kinked = [](double m) { return 1e-6 * std::exp(-std::abs(m - 500e3) / 50e3); };
  const auto light = estimated(sums_of(means_of(kinked, 50e3, 20), 50e3, 1e-3));
  const StoppingRule rule{{1}, 0.01, 0, 1e6};
  EXPECT_LT(worst_error(light, rule), 0.003) << "twice the noise, and a tenth";
  EXPECT_GT(light.standard_error[0](9, 0), 0.05 * light.ratio[0](9, 0)) << "a test of kinks";
}

TEST(BlockRange, OfPhotonsIsRoundedUp) {
  EXPECT_EQ(blocks_of(1), (BlockRange{0, 1}));
  EXPECT_EQ(blocks_of(1024), (BlockRange{0, 1}));
  EXPECT_EQ(blocks_of(1025), (BlockRange{0, 2}));
}

TEST(Shards, AreAllTheBlocksAndNoneTwice) {
  std::uint64_t next = 5;
  for (std::uint64_t part = 1; part <= 7; ++part) {
    const auto blocks = shard({5, 29}, part, 7);
    EXPECT_EQ(blocks.from, next);
    EXPECT_GE(blocks.to - blocks.from, 3U);
    EXPECT_LE(blocks.to - blocks.from, 4U);
    next = blocks.to;
  }
  EXPECT_EQ(next, 29U);
  EXPECT_THROW(shard({0, 10}, 0, 3), algebra::Error);
  EXPECT_THROW(shard({0, 10}, 4, 3), algebra::Error);
}

}  // namespace coppermoon::shadow::photon_sums_test
