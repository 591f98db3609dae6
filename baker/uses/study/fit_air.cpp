// SPDX-License-Identifier: MIT
#include "uses/study/fit_air.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace coppermoon::uses {
namespace {

std::vector<double> evenly(double from, double to, int steps) {
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) all.push_back(from + (to - from) * i / steps);
  return all;
}

constexpr std::array steps{32, 24, 14};

/// Axes over the whole search range, in steps of 17 % of dust, 0.04 of cover, 29 DU of ozone.
Axes whole_axes() {
  const auto [dust, cover, ozone] = search_range;
  return {evenly(std::log(dust.least), std::log(dust.most), steps[0]),
          evenly(cover.least, cover.most, steps[1]), evenly(ozone.least, ozone.most, steps[2])};
}

/// Axes of as many steps over what is probable after a look at all of it.
Axes axes_about(const Posterior& known, const Axes& whole) {
  constexpr double beyond = 2;  // of the interval, to either side of it: five deviations in all
  Axes axes;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto& [median, low, high, information] = known.estimates[a];
    const double step = whole[a][1] - whole[a][0], width = std::max(high - low, step);
    axes[a] = evenly(std::max(whole[a].front(), low - beyond * width),
                     std::min(whole[a].back(), high + beyond * width), steps[a]);
  }
  return axes;
}

/// Adds χ² for each cloud cover, at one dust and ozone.
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

/// χ² of all witnesses: (dust × ozones + ozone, cover).
algebra::Grid<double> chi_squared_over(const Axes& axes, std::span<const Witness> witnesses) {
  const auto &dusts = axes[0], &covers = axes[1], &ozones = axes[2];
  algebra::Grid<double> chi_squared(dusts.size() * ozones.size(), covers.size());
  tbb::parallel_for(std::size_t{0}, chi_squared.rows(), [&](std::size_t row) {
    const double dust = std::exp(dusts[row / ozones.size()]), ozone = ozones[row % ozones.size()];
    for (const auto& witness : witnesses)
      add_over_cover(witness, witness.light->mixed(dust, ozone), covers, chi_squared.row(row));
  });
  return chi_squared;
}

/// What is known with all errors larger by the root of a factor.
Posterior posterior_over(const Axes& axes, const algebra::Grid<double>& chi_squared,
                         double larger) {
  return posterior(axes, [&](const std::array<std::size_t, 3>& at) {
    return chi_squared(at[0] * axes[2].size() + at[2], at[1]) / larger;
  });
}

double least_of(const algebra::Grid<double>& chi_squared) {
  return *std::ranges::min_element(chi_squared.values());
}

/// Count of numbers above the three unknowns, 1 or more.
double freedom_of(std::size_t numbers) { return std::max(1., static_cast<double>(numbers) - 3); }

}  // namespace

double most_chi_squared(const AirFit& fit) { return 10 * freedom_of(fit.numbers); }

bool explains(const AirFit& fit) {
  return fit.posterior.least_chi_squared <= most_chi_squared(fit);
}

AirFit fitted_air(std::span<const Witness> witnesses) {
  constexpr int looks = 3;
  AirFit result;
  for (const auto& witness : witnesses) result.numbers += witness.count;
  const double freedom = freedom_of(result.numbers);
  const auto whole = whole_axes();
  auto axes = whole;
  for (int look = 1;; ++look) {
    const auto chi_squared = chi_squared_over(axes, witnesses);
    const double least = least_of(chi_squared);
    result.posterior = posterior_over(axes, chi_squared, std::max(1., least / freedom));
    result.posterior.least_chi_squared = least;
    if (look == looks) break;
    axes = axes_about(result.posterior, axes);
  }
  for (std::size_t a = 0; a < whole.size(); ++a) {  // over what was allowed, not what was looked at
    auto& information = result.posterior.estimates[a].information;
    const double looked = axes[a].back() - axes[a].front(),
                 allowed = whole[a].back() - whole[a].front();
    information = 1 - (1 - information) * looked * looked / (allowed * allowed);
  }
  return result;
}

}  // namespace coppermoon::uses
