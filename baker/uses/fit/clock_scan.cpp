// SPDX-License-Identifier: MIT
#include "uses/fit/clock_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "colour/tone_curve.h"
#include "eclipse/shadow_axis.h"
#include "uses/compare/comparison.h"
#include "uses/fit/sky_and_glow.h"

namespace coppermoon::uses {
namespace {

using Cell = ClockView::Cell;

/// Difference from a model's logarithm of light; where a cell is not well seen, only as far as it is beyond.
double difference(const Cell& cell, double model) {
  const double beyond = model - cell.light;
  if (cell.seen == Cell::Seen::dark) return std::max(0., beyond);
  if (cell.seen == Cell::Seen::clipped) return std::min(0., beyond);
  return beyond;
}

/// Mean square of the differences, each cut at 1.
double mean_square(std::span<const Cell> cells, std::span<const double> model, double exposure) {
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double one = difference(cells[i], model[i] + exposure);
    sum += std::min(1., one * one);
  }
  return sum / static_cast<double>(cells.size());
}

/// A correction, and the logarithm of the mean misfit.
struct Tried {
  double clock_s, misfit;
};

double logarithm_of_misfit(const FitGroundwork& groundwork, std::span<const ClockView> views,
                           double clock_s) {
  constexpr double exact = 0.01;
  double sum = 0;
  for (const auto& view : views) sum += misfit_at(groundwork, view, clock_s);
  return std::log(exact + sum / static_cast<double>(views.size()));
}

bool shows_partial_phase(std::span<const ClockView> views, double clock_s) {
  return std::ranges::any_of(views, [=](const ClockView& view) {
    return !lies_in_umbra(almanac::sky_at(almanac::later(view.instant, clock_s)));
  });
}

}  // namespace

ClockView clock_view(const FitScene& scene, const texture::Image& photo,
                     const colour::Similarity& render_to_photo, bool curved,
                     const almanac::Instant& instant) {
  constexpr std::size_t cell_px = 16, across = fit_side_px / cell_px, least_pixels = 60;
  constexpr double skies = 2;
  const auto displayed = colour::resampled(luminance_of(photo), colour::inverse(render_to_photo),
                                           fit_side_px, fit_side_px);
  const double sky = std::max(0., median_of(around_the_disc(displayed))),
               least = std::max(colour::least_displayed, skies * sky);
  struct Sum {
    glm::dvec3 ground{};
    double sunlit = 0, displayed = 0;
    std::size_t pixels = 0;
  };
  std::vector<Sum> sums(across * across);
  for (const auto& one : scene.grounds) {
    const auto row = one.pixel / fit_side_px / cell_px, column = one.pixel % fit_side_px / cell_px;
    auto& sum = sums[row * across + column];
    sum.ground += one.ground;
    sum.sunlit += one.sunlit;
    sum.displayed += displayed.values()[one.pixel];
    ++sum.pixels;
  }
  const auto light_of = [&](double value) {
    return std::log(value) + (curved ? colour::tone_logarithm({}, value) : 0);
  };
  ClockView view{instant, {}};
  for (const auto& [ground, sunlit, sum, pixels] : sums) {
    if (pixels < least_pixels) continue;
    const auto count = static_cast<double>(pixels);
    const double value = sum / count, sky_off = std::max(least / 2, value - sky);
    using enum Cell::Seen;
    const auto seen = value < least ? dark : value > colour::most_displayed ? clipped : well;
    view.cells.push_back({glm::normalize(ground), sunlit / count,
                          light_of(seen == dark      ? least
                                   : seen == clipped ? colour::most_displayed
                                                     : sky_off),
                          seen});
  }
  return view;
}

double misfit_at(const FitGroundwork& groundwork, const ClockView& view, double clock_s) {
  constexpr std::size_t exposures = 16;
  const auto sky = almanac::sky_at(almanac::later(view.instant, clock_s));
  const auto axis = eclipse::shadow_axis(sky);
  std::vector<double> model, offsets;
  std::array<double, 3> xyz{};
  for (const auto& cell : view.cells) {
    groundwork.usual.read(eclipse::place_of_ground(axis, sky, cell.ground), xyz);
    model.push_back(std::log(std::max(1e-12, xyz[1] * cell.sunlit)));
    if (cell.seen == Cell::Seen::well) offsets.push_back(cell.light - model.back());
  }
  if (offsets.empty()) return 0;
  std::ranges::sort(offsets);
  double least = 1;
  for (std::size_t i = 0; i < exposures; ++i)
    least = std::min(least, mean_square(view.cells, model,
                                        offsets[(2 * i + 1) * offsets.size() / (2 * exposures)]));
  return least;
}

ScannedClock scanned_clock(const FitGroundwork& groundwork, std::span<const ClockView> views,
                           double from_s, double to_s,
                           const std::function<double(double clock_s)>& believed) {
  constexpr double wide_s = 300, of_partial = 10, of_total = 0.3, most_believed = 9;
  const auto tried = [&](double from, double to, double step_s) {
    std::vector<Tried> all;
    for (double clock_s = from; clock_s <= to; clock_s += step_s)
      all.push_back({clock_s, logarithm_of_misfit(groundwork, views, clock_s)});
    return all;
  };
  const auto widely = tried(from_s, to_s, wide_s);
  const double alike_s = std::ranges::min(widely, {}, &Tried::misfit).clock_s;
  const bool decided = shows_partial_phase(views, alike_s);
  const double weight = static_cast<double>(views.size()) * (decided ? of_partial : of_total);
  const auto chi_squared_of = [&](const Tried& one) {
    const double prior = believed(one.clock_s);
    return weight * one.misfit + (decided ? std::min(most_believed, prior) : prior);
  };
  const auto best_of = [&](const std::vector<Tried>& all) {
    return std::ranges::min(all, {}, chi_squared_of).clock_s;
  };
  double best_s = best_of(widely);
  for (const auto& [about_s, step_s] : {std::pair{300., 60.}, {45., 15.}})
    best_s = best_of(tried(best_s - about_s, best_s + about_s, step_s));
  return {best_s, decided};
}

}  // namespace coppermoon::uses
