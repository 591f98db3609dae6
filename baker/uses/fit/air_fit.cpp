// SPDX-License-Identifier: MIT
#include "uses/fit/air_fit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace coppermoon::uses {
namespace {

std::vector<double> evenly(double from, double to, int steps) {
  std::vector<double> all;
  for (int i = 0; i <= steps; ++i) all.push_back(from + (to - from) * i / steps);
  return all;
}

/// Usual and greatest number of grids on which χ² is evaluated, one after the other. The first grid finds the probable
/// range of the unknowns. Later grids have steps of about half a standard deviation. If the steps of the third grid are
/// still too coarse, more grids follow. `axis_steps` is the number of steps along each axis.
constexpr std::size_t looks = 3, most_looks = 6;
constexpr std::array<std::array<int, 3>, looks> axis_steps{
    {{20, 14, 8}, {20, 16, 10}, {24, 20, 12}}};

/// Whether each axis of the grid has steps smaller than a standard deviation of the posterior.
bool are_fine(const Axes& axes, const Posterior& posterior) {
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto& estimate = posterior.estimates[a];
    if (axes[a][1] - axes[a][0] > (estimate.high - estimate.low) / 2) return false;
  }
  return true;
}

/// Axes of a grid that covers the given range of the unknowns.
Axes axes_over(Unknowns unknowns, const AirRange& range) {
  Axes axes;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto& unknown = unknowns_of(unknowns)[a];
    axes[a] = evenly(unknown.on_axis(range[a][0]), unknown.on_axis(range[a][1]), axis_steps[0][a]);
  }
  return axes;
}

/// Range of the unknowns for which the light of every data set has been computed.
AirRange range_of(std::span<const DataSet> data) {
  auto range = data.front().light.range();
  for (const auto& set : data)
    for (std::size_t a = 0; a < range.size(); ++a) {
      range[a][0] = std::max(range[a][0], set.light.range()[a][0]);
      range[a][1] = std::min(range[a][1], set.light.range()[a][1]);
    }
  return range;
}

/// Axes of a finer grid, over the range of the unknowns that proved probable on a coarser grid.
Axes axes_about(const Posterior& known, const Axes& coarser, std::size_t look) {
  constexpr double beyond = 2;  // margin in widths of the 68 % interval, so axes extend to 5 sigma
  Axes axes;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    const auto& [median, low, high, information] = known.estimates[a];
    const double step = coarser[a][1] - coarser[a][0], width = std::max(high - low, step);
    axes[a] = evenly(std::max(coarser[a].front(), low - beyond * width),
                     std::min(coarser[a].back(), high + beyond * width),
                     axis_steps[std::min(look, looks - 1)][a]);
  }
  return axes;
}

/// χ² and clock corrections at each grid point. The row index is aerosol × ozones + ozone, the column index is cloud.
struct Evaluation {
  algebra::Grid<double> chi_squared;
  std::vector<algebra::Grid<ClockError>> clocks;  ///< one grid of corrections for each data set
};

/// At one value of aerosol and ozone, adds a data set's χ² for each amount of cloud and stores its clock corrections.
void add_over_cloud(const DataSet& data, const FittedLight::OverCloud& light,
                    const std::vector<double>& clouds, std::span<double> chi_squared,
                    std::span<ClockError> clocks) {
  for (std::size_t j = 0; j < clouds.size(); ++j) {
    const auto found = data.goodness(light.under(clouds[j]));
    chi_squared[j] += found.chi_squared;
    clocks[j] = {found.clock_s, std::sqrt(found.clock_variance_s2), {}};
  }
}

/// Values of an unknown at the coordinates of a grid axis, which may be logarithms.
std::vector<double> values_on(const std::vector<double>& axis, const Unknown& unknown) {
  std::vector<double> values;
  for (const double place : axis) values.push_back(unknown.from_axis(place));
  return values;
}

Evaluation evaluated(const Axes& axes, std::span<const DataSet> data,
                     const algebra::Progress& progress) {
  const auto& unknowns = unknowns_of(data.front().light.unknowns());
  const auto aerosols = values_on(axes[0], unknowns[0]), clouds = values_on(axes[1], unknowns[1]),
             ozones = values_on(axes[2], unknowns[2]);
  const auto rows = aerosols.size() * ozones.size();
  Evaluation all{algebra::Grid<double>(rows, clouds.size()), {}};
  all.clocks.assign(data.size(), algebra::Grid<ClockError>(rows, clouds.size()));
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    const double aerosol = aerosols[row / ozones.size()], ozone = ozones[row % ozones.size()];
    for (std::size_t d = 0; d < data.size(); ++d)
      add_over_cloud(data[d], data[d].light.over_cloud(aerosol, ozone), clouds,
                     all.chi_squared.row(row), all.clocks[d].row(row));
    progress(static_cast<double>(++done) / static_cast<double>(rows));
  });
  return all;
}

/// Mean and standard error of a clock correction over the posterior on a grid. Variances are multiplied by `scale`.
ClockError over_all_air(const algebra::Grid<double>& chi_squared, double scale,
                        const algebra::Grid<ClockError>& clocks) {
  const double least = *std::ranges::min_element(chi_squared.values());
  double sum = 0, mean = 0, squares = 0;
  for (std::size_t i = 0; i < chi_squared.values().size(); ++i) {
    const double mass = std::exp((least - chi_squared.values()[i]) / 2);
    const auto& [seconds, error_s, zone] = clocks.values()[i];
    sum += mass;
    mean += mass * seconds;
    squares += mass * (seconds * seconds + scale * error_s * error_s);
  }
  mean /= sum;
  return {mean, std::sqrt(std::max(0., squares / sum - mean * mean)), {}};
}

/// Total χ² on a grid: that of the data, whose variances are enlarged by the factor `scale`, plus that of the prior.
algebra::Grid<double> with_prior(const Axes& axes, const std::array<Unknown, 3>& unknowns,
                                 algebra::Grid<double> chi_squared, double scale) {
  for (std::size_t row = 0; row < chi_squared.rows(); ++row)
    for (std::size_t j = 0; j < axes[1].size(); ++j)
      chi_squared(row, j) = chi_squared(row, j) / scale +
                            unknowns[0].chi_squared_of_prior(axes[0][row / axes[2].size()]) +
                            unknowns[1].chi_squared_of_prior(axes[1][j]) +
                            unknowns[2].chi_squared_of_prior(axes[2][row % axes[2].size()]);
  return chi_squared;
}

/// Posterior from χ² on a grid. If the grid's steps are fine enough, χ² is interpolated between the grid points.
Posterior posterior_over(const Axes& axes, const algebra::Grid<double>& chi_squared) {
  std::vector<double> in_order;
  for (std::size_t i = 0; i < axes[0].size(); ++i)
    for (std::size_t j = 0; j < axes[1].size(); ++j)
      for (std::size_t k = 0; k < axes[2].size(); ++k)
        in_order.push_back(chi_squared(i * axes[2].size() + k, j));
  const auto on_grid = posterior(axes, in_order);
  if (!are_fine(axes, on_grid)) return on_grid;
  auto finer_axes = axes;
  make_finer(finer_axes, in_order);
  return posterior(finer_axes, in_order);
}

/// Most probable values of the unknowns.
AirNumbers best_of(const Axes& axes, const std::array<Unknown, 3>& unknowns,
                   const algebra::Grid<double>& chi_squared) {
  const auto place = static_cast<std::size_t>(std::ranges::min_element(chi_squared.values()) -
                                              chi_squared.values().begin());
  const auto row = place / chi_squared.columns();
  return {unknowns[0].from_axis(axes[0][row / axes[2].size()]),
          unknowns[1].from_axis(axes[1][place % chi_squared.columns()]),
          unknowns[2].from_axis(axes[2][row % axes[2].size()])};
}

/// Degrees of freedom of a fit to the given number of measurements, 1 or more.
double freedom_of(std::size_t measurements) {
  return std::max(1., static_cast<double>(measurements) - 3);
}

/// χ² one standard deviation above its expected value. If errors are as assumed, one fit in six has a χ² above this.
double chi_squared_by_chance(double freedom) { return freedom + std::sqrt(2 * freedom); }

}  // namespace

AirRange range_about(const AirFit& fit) {
  constexpr double beyond = 3, least_share = 0.25, least_of_ozone = 0.1;
  auto range = whole_range(fit.unknowns);
  for (std::size_t a = 0; a < range.size(); ++a) {
    const auto& unknown = unknowns_of(fit.unknowns)[a];
    const auto& [median, low, high, information] = fit.posterior.estimates[a];
    const double share = a == 2 ? least_of_ozone : least_share,
                 least = unknown.logarithmic ? share : share * std::abs(median),
                 length = std::max(beyond * (high - low), least);
    range[a] = {std::max(range[a][0], unknown.from_axis(low - length)),
                std::min(range[a][1], unknown.from_axis(high + length))};
  }
  return range;
}

bool is_well_within(const AirFit& fit, const AirRange& range) {
  const auto whole = whole_range(fit.unknowns);
  for (std::size_t a = 0; a < range.size(); ++a) {
    const auto& unknown = unknowns_of(fit.unknowns)[a];
    const auto& [median, low, high, information] = fit.posterior.estimates[a];
    const double width = high - low;
    if ((range[a][0] > whole[a][0] && low - width < unknown.on_axis(range[a][0])) ||
        (range[a][1] < whole[a][1] && high + width > unknown.on_axis(range[a][1])))
      return false;
  }
  return true;
}

double most_chi_squared(const AirFit& fit) { return 10 * freedom_of(fit.measurements); }

bool explains(const AirFit& fit) {
  return fit.posterior.least_chi_squared <= most_chi_squared(fit);
}

AirFit fitted_air(std::span<const DataSet> data, const algebra::Progress& progress) {
  AirFit result;
  double least_scale = 1;
  for (const auto& set : data) {
    result.measurements += set.count;
    least_scale = std::max(least_scale, set.least_scale);
  }
  const double freedom = freedom_of(result.measurements);
  result.unknowns = data.front().light.unknowns();
  auto axes = axes_over(result.unknowns, range_of(data));
  for (std::size_t look = 1;; ++look) {
    const auto [chi_squared, clocks] = evaluated(axes, data, [&](double part) {
      const auto all = static_cast<double>(std::max(look, looks));
      if (progress) progress((static_cast<double>(look - 1) + part) / all);
    });
    const double least = *std::ranges::min_element(chi_squared.values()),
                 scale = std::max(least_scale, least / chi_squared_by_chance(freedom));
    const auto& unknowns = unknowns_of(result.unknowns);
    const auto whole = with_prior(axes, unknowns, chi_squared, scale);
    result.posterior = posterior_over(axes, whole);
    result.posterior.least_chi_squared = least;
    if (look == most_looks || (look >= looks && are_fine(axes, result.posterior))) {
      result.best = best_of(axes, unknowns, whole);
      for (const auto& clock : clocks) result.clocks.push_back(over_all_air(whole, scale, clock));
      break;
    }
    axes = axes_about(result.posterior, axes, look);
  }
  // so far, information is relative to the last grid's range; make it relative to the prior over the whole range
  const auto whole = axes_over(result.unknowns, whole_range(result.unknowns));
  for (std::size_t a = 0; a < whole.size(); ++a) {
    auto& information = result.posterior.estimates[a].information;
    const double share = (axes[a].back() - axes[a].front()) / (whole[a].back() - whole[a].front());
    const double deviation = unknowns_of(result.unknowns)[a].deviation,
                 length = whole[a].back() - whole[a].front(),
                 narrower = deviation > 0 ? length * length / 12 / (deviation * deviation) : 1;
    information = std::max(0., 1 - (1 - information) * share * share * std::max(1., narrower));
  }
  return result;
}

}  // namespace coppermoon::uses
