// SPDX-License-Identifier: MIT
#include <cmath>

#include "baker/shadow/ring_means.h"
#include "shadow/by_photons.h"
#include "support/within.h"

namespace coppermoon::shadow {
namespace {

/// Root mean square of the relative error over 8 rings of 1000 km, three wavelengths and some
/// seeds.
double relative_error(std::uint64_t photons, std::uint64_t seeds) {
  const Arrangement february_2008{1.479e11, {3.83e8}};
  const std::vector<double> waves{500, 580, 680};
  constexpr double ring_m = 1000e3;
  constexpr std::size_t rings = 8;
  const auto exact = ring_means({}, february_2008, waves, ring_m, rings);
  double sum = 0;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    PhotonSettings settings;
    settings.photons = photons;
    settings.ring_width_m = ring_m;
    settings.seed = seed;
    const auto light = by_photons({}, february_2008, waves, settings);
    for (std::size_t r = 2; r < rings; ++r)
      for (std::size_t w = 0; w < waves.size(); ++w, ++count)
        sum += std::pow(light.ratio[0](r, w) / exact(r, w) - 1, 2);
  }
  return std::sqrt(sum / count);
}

TEST(Convergence, FallsWithTheSquareRootOfTheNumberOfPhotonsOverThreeDecades) {
  const double few = relative_error(1'000, 12), many = relative_error(1'000'000, 2);
  const double slope = std::log10(many / few) / 3;
  // 216 and 36 squared errors: the roots are known to 5 and 12 %, the slope to 0.019; 3.3 times
  // that.
  EXPECT_WITHIN(slope, -0.5, 0.06, "one run in a thousand of a true −1/2 fails");
}

}  // namespace
}  // namespace coppermoon::shadow
