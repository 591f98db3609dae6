// SPDX-License-Identifier: MIT
#include "verbs/fit_air.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace coppermoon::verbs {
namespace {

std::vector<double> evenly(double from, double to, int steps) {
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) all.push_back(from + (to - from) * i / steps);
  return all;
}

/// Steps of 5 % of dust, 0.02 of cover, 25 DU of ozone.
Axes axes_of() {
  const auto [dust, cover, ozone] = sought;
  return {evenly(std::log(dust.least), std::log(dust.most), 100),
          evenly(cover.least, cover.most, 50), evenly(ozone.least, ozone.most, 16)};
}

/// What cloud mixes, of one dust and ozone: χ² for each cover.
void add_over_cover(const Witness& witness, const FittedLight::Mixed& mixed,
                    const std::vector<double>& covers, std::span<double> chi_squared) {
  auto light = mixed.clear;
  for (std::size_t j = 0; j < covers.size(); ++j) {
    for (std::size_t i = 0; i < light.values().size(); ++i) {
      const double clear = mixed.clear.values()[i];
      light.values()[i] = clear + covers[j] * (mixed.cloudy.values()[i] - clear);
    }
    chi_squared[j] += witness.chi_squared(light);
  }
}

}  // namespace

AirFit fitted_air(std::span<const Witness> witnesses) {
  const auto axes = axes_of();
  const auto& [dusts, covers, ozones] = axes;
  algebra::Grid<double> chi_squared(dusts.size() * ozones.size(), covers.size());
  tbb::parallel_for(std::size_t{0}, chi_squared.rows(), [&](std::size_t row) {
    const double dust = std::exp(dusts[row / ozones.size()]), ozone = ozones[row % ozones.size()];
    for (const auto& witness : witnesses)
      add_over_cover(witness, witness.light->mixed(dust, ozone), covers, chi_squared.row(row));
  });
  AirFit result{{}, 0};
  for (const auto& witness : witnesses) result.numbers += witness.count;
  const double least = *std::ranges::min_element(chi_squared.values());
  const double freedom = std::max(1., static_cast<double>(result.numbers) - 3);
  const double larger = std::max(1., least / freedom);
  result.posterior = posterior(axes, [&](const std::array<std::size_t, 3>& at) {
    return chi_squared(at[0] * ozones.size() + at[2], at[1]) / larger;
  });
  result.posterior.least_chi_squared = least;
  return result;
}

}  // namespace coppermoon::verbs
