// SPDX-License-Identifier: MIT
#include "baker/shadow/ring_means.h"
#include "shadow/by_photons.h"
#include "support/testing.h"

namespace coppermoon::shadow::convergence_test {

/// Rings from one to another, without that.
struct Cut {
  double width_m;
  std::size_t from, to;
};

/// Root mean square of the relative error over rings, three wavelengths and some seeds.
double relative_error(bool literal, Cut rings, std::uint64_t photons, std::uint64_t seeds) {
  const Arrangement february_2008{1.479e11, {3.83e8}};
  const std::vector<double> waves{500, 580, 680};
  const auto exact = ring_means({}, february_2008, waves, rings.width_m, rings.to);
  double sum = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    PhotonSettings settings;
    settings.photons = photons;
    settings.literal = literal;
    settings.ring_width_m = rings.width_m;
    settings.seed = seed;
    const auto light = in_rings({}, february_2008, waves, settings);
    for (std::size_t r = rings.from; r < rings.to; ++r)
      for (std::size_t w = 0; w < waves.size(); ++w, ++count)
        sum += std::pow(light.ratio[0](r, w) / exact(r, w) - 1, 2);
  }
  return std::sqrt(sum / count);
}

TEST(Convergence, FallsWithTheSquareRootOfTheNumberOfPhotonsOverThreeDecades) {
  constexpr Cut wide{1000e3, 2, 8};
  const double few = relative_error(true, wide, 1'000, 12),
               many = relative_error(true, wide, 1'000'000, 2);
  const double slope = std::log10(many / few) / 3;
  // 216 and 36 squared errors: the roots are known to 5 and 12 %, the slope to 0.019; 3.3 times
  // that.
  EXPECT_WITHIN(slope, -0.5, 0.06, "one run in a thousand of a true −1/2 fails");
}

TEST(Convergence, ByTheTableFallsAtLeastAsFast) {
  constexpr Cut narrow{100e3, 0, 45};
  const double few = relative_error(false, narrow, 16'384, 8),
               many = relative_error(false, narrow, 16'384'000, 1);
  // 360 and 45 errors, wavelengths together: their roots are known to 4 and 11 %, the slope to 0.016;
  // 3.3 times that, and the reference's own 2e-4.
  EXPECT_LT(std::log10(many / few) / 3, -0.5 + 0.06) << "one run in a thousand of a true −1/2";
}

}  // namespace coppermoon::shadow::convergence_test
