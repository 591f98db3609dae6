// SPDX-License-Identifier: MIT
#include "shadow/scattered_row.h"

#include "algebra/random.h"
#include "shadow/padding.h"
#include "support/testing.h"

namespace coppermoon::shadow::scattered_row_test {

TEST(ScatteredRow, IsEachAbsorbersLightDimmedByAll) {
  constexpr std::size_t waves = 13, groups = padded(waves, waves_together);
  static_assert(groups == 16);
  algebra::Random random(20, 0);
  algebra::Grid<double> spectra(atmosphere::absorbers, groups);
  atmosphere::Amounts scattered{}, passed{};
  std::vector<double> filter(groups), ratio(groups, 1e-9);
  for (std::size_t w = 0; w < waves; ++w) filter[w] = random.uniform();
  for (std::size_t k = 1; k < scattered.size(); ++k) {  // the first is not in this air
    for (std::size_t w = 0; w < waves; ++w) spectra(k, w) = random.uniform();
    scattered[k] = 1e-9 * random.uniform();
    passed[k] = k == 2 ? 0 : 20 * random.uniform();
  }
  add_scattered(scattered, passed, spectra, filter, ratio);
  for (std::size_t w = 0; w < groups; ++w) {
    double light = 0, depth = 0;
    for (std::size_t k = 0; k < scattered.size(); ++k) {
      light += spectra(k, w) * scattered[k];
      depth += spectra(k, w) * passed[k];
    }
    EXPECT_WITHIN_RELATIVE(ratio[w], 1e-9 + filter[w] * light * std::exp(-depth), 1e-13,
                           "rounding of exponents up to 100")
        << w;
  }
}

TEST(ScatteredRow, BehindAWallIsDark) {
  algebra::Grid<double> spectra(atmosphere::absorbers, waves_together, 1.);
  atmosphere::Amounts scattered{}, passed{};
  scattered[0] = 1;
  passed[0] = 1e9;
  const std::vector<double> filter(waves_together, 1.);
  std::vector<double> ratio(waves_together);
  add_scattered(scattered, passed, spectra, filter, ratio);
  for (const double value : ratio) EXPECT_WITHIN(value, 0, 1e-300, "darkest");
}

}  // namespace coppermoon::shadow::scattered_row_test
