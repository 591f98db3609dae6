// SPDX-License-Identifier: MIT
#include "uses/fit/clock_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "almanac/calendar.h"
#include "colour/tone_curve.h"
#include "eclipse/contacts.h"
#include "eclipse/shadow_axis.h"
#include "uses/compare/comparison.h"
#include "uses/fit/sky_and_glow.h"

namespace coppermoon::uses {
namespace {

using Cell = ClockView::Cell;

/// Logarithm of a model's light minus that of a cell's light. The light of a dark or clipped cell is only a limit, so
/// the difference is 0 if the model lies within that limit.
double difference(const Cell& cell, double model) {
  const double beyond = model - cell.light;
  if (cell.seen == Cell::Seen::dark) return std::max(0., beyond);
  if (cell.seen == Cell::Seen::clipped) return std::min(0., beyond);
  return beyond;
}

/// Mean squared difference between the model and the cells. Each square is limited to 1.
double mean_square(std::span<const Cell> cells, std::span<const double> model, double exposure) {
  double sum = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double one = difference(cells[i], model[i] + exposure);
    sum += std::min(1., one * one);
  }
  return sum / static_cast<double>(cells.size());
}

/// A clock correction that was tried, and the logarithm of the mean misfit it gave.
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

constexpr double half_hour_s = 1800;

/// Half the range of a scanned clock, in standard deviations.
constexpr double deviations = 3;

/// Range of possible clock corrections [s].
struct Possible {
  double from_s, to_s;
};

/// Largest clock correction to try [s], apart from the whole half hours that a wrong time zone adds. It is 0 if the
/// clock's error is so small that light changes linearly within it.
double farthest_clock_s(const FitRequest& request) {
  constexpr double linear_s = 300, errors = 3;  // light changes linearly within linear_s
  const double error_s = request.clock_error_s;
  return std::max(request.clock_search_s, error_s > linear_s ? errors * error_s : 0);
}

eclipse::Contacts contacts_of(const FitRequest& request) {
  return eclipse::nearest_eclipse(request.photographs.front().instant,
                                  eclipse::ShadowConvention::danjon)
      .contacts;
}

/// Range of clock corrections to search. With half_hours_free, each end is chosen so that the most photographs fall in
/// the eclipse.
Possible possible_clocks(const FitRequest& request) {
  if (!request.half_hours_free) return {-farthest_clock_s(request), farthest_clock_s(request)};
  constexpr std::size_t minutes = 16;  // letters of a moment, without seconds
  constexpr int farthest = 52;         // in half hours; time zones differ by up to 26 hours
  const auto contacts = contacts_of(request);
  Possible range{};
  std::ptrdiff_t most = 0;
  for (int step = -farthest; step <= farthest; ++step) {
    const double clock_s = step * half_hour_s;
    const auto eclipsed = std::ranges::count_if(request.photographs, [&](const auto& photograph) {
      const auto moment = almanac::later(photograph.instant, clock_s);
      return almanac::seconds_between(*contacts.P1, moment) > 0 &&
             almanac::seconds_between(moment, *contacts.P4) > 0;
    });
    if (eclipsed > most) most = eclipsed, range.from_s = clock_s;
    if (eclipsed == most) range.to_s = clock_s;
  }
  if (most == 0)
    throw algebra::Error(fmt::format(
        "{}: dated {}, which no time zone puts into the eclipse of {}: its clock was wrong",
        request.photographs.front().file,
        almanac::utc_text(request.photographs.front().instant).substr(0, minutes),
        almanac::date_text(*contacts.P1)));
  return range;
}

/// Indices of at most `most` photographs, spaced evenly from the first photograph to the last.
std::vector<std::size_t> some_of(std::size_t all, std::size_t most) {
  const auto count = std::min(most, all);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i)
    indices.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
  return indices;
}

/// Clock correction, in steps of half an hour, at which the photographs best match the computed Moon. The match
/// improves as the computed shadow approaches its true place.
double roughly_at(const Stage& stage, std::span<const Reading> readings,
                  std::span<const std::size_t> which, const Possible& range) {
  std::vector<double> clocks_s;
  for (double s = std::ceil(range.from_s / half_hour_s) * half_hour_s; s <= range.to_s;
       s += half_hour_s)
    clocks_s.push_back(s);
  std::ranges::sort(clocks_s, {}, [](double s) { return std::abs(s); });
  double most = 0, best_s = clocks_s.front();
  for (const double clock_s : clocks_s) {
    double alike = 0;
    for (const auto& one : placed(stage, readings, clock_s, which, Registering::rough))
      if (one.left_out.empty()) alike += one.registration.correlation;
    if (alike > most) most = alike, best_s = clock_s;
  }
  return best_s;
}

/// ClockViews of the chosen photographs, registered with a given clock correction. Failed registrations are skipped.
std::vector<ClockView> views_at(const Stage& stage, std::span<const Reading> readings,
                                std::span<const std::size_t> which, double clock_s) {
  const auto all = placed(stage, readings, clock_s, which, Registering::fine);
  std::vector<ClockView> views;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].left_out.empty())
      views.push_back(clock_view(*all[i].scene, readings[i].moon.photo,
                                 all[i].registration.render_to_photo, readings[i].curved,
                                 stage.request.photographs[i].instant));
  return views;
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
  const auto bound = [&](double step_s) {
    const double most = deviations * deviations +
                        chi_squared_of({best_s, logarithm_of_misfit(groundwork, views, best_s)});
    double clock_s = best_s;
    while (std::abs(clock_s - best_s) < half_hour_s &&
           chi_squared_of({clock_s, logarithm_of_misfit(groundwork, views, clock_s)}) < most)
      clock_s += step_s;
    return clock_s;
  };
  constexpr double step_s = 60;
  return {best_s, decided, bound(-step_s), bound(step_s)};
}

bool strays(const Clock& clock) {
  const auto& scan = clock.scanned;
  return scan && (clock.added_s < scan->from_s || clock.added_s > scan->to_s);
}

Clock scanned_again(const Clock& clock) {
  constexpr double least_error_s = 60;
  const auto& scan = clock.scanned.value();
  return {scan.seconds, scan.seconds,
          std::max(least_error_s, (scan.to_s - scan.from_s) / (2 * deviations)), scan};
}

bool clock_is_free(const FitRequest& request) {
  return request.half_hours_free || farthest_clock_s(request) > 0;
}

std::vector<almanac::SkyState> skies_of(const FitRequest& request) {
  constexpr double step_s = 300;
  std::vector<almanac::SkyState> skies;
  const auto add = [&](const almanac::Instant& from, const almanac::Instant& to) {
    for (double s = 0; s <= almanac::seconds_between(from, to); s += step_s)
      skies.push_back(almanac::sky_at(almanac::later(from, s)));
  };
  if (clock_is_free(request) || request.clock_error_s > 0) {
    const auto contacts = contacts_of(request);
    add(*contacts.P1, *contacts.P4);
  } else {
    const auto [first, last] =
        std::ranges::minmax(request.photographs, [](const auto& one, const auto& other) {
          return almanac::seconds_between(one.instant, other.instant) > 0;
        });
    add(first.instant, last.instant);
    if (almanac::seconds_between(skies.back().when, last.instant) > 0)
      skies.push_back(almanac::sky_at(last.instant));
  }
  return skies;
}

Clock scanned_clock(const Stage& stage, std::span<const Reading> readings) {
  constexpr std::size_t enough = 6;
  constexpr double near_s = 300, about_s = 1200, least_error_s = 60;
  const auto& request = stage.request;
  Clock clock{.error_s = request.clock_error_s};
  if (!clock_is_free(request)) return clock;
  const bool free = request.half_hours_free;
  const auto nearest_s = [=](double clock_s) {
    return free ? std::round(clock_s / half_hour_s) * half_hour_s : 0;
  };
  const double error_s = std::max(least_error_s, clock.error_s);
  const auto believed = [&](double clock_s) {
    return std::pow((clock_s - nearest_s(clock_s)) / error_s, 2);
  };
  const auto range = possible_clocks(request);
  const auto which = some_of(readings.size(), enough);
  const double roughly_s = roughly_at(stage, readings, which, range);
  auto views = views_at(stage, readings, which, roughly_s);
  if (views.empty()) return clock;
  const double margin_s = free ? half_hour_s / 2 : 0;
  auto found = scanned_clock(stage.groundwork, views, range.from_s - margin_s,
                             range.to_s + margin_s, believed);
  if (std::abs(found.seconds - roughly_s) > near_s) {
    views = views_at(stage, readings, which, found.seconds);
    if (!views.empty())
      found = scanned_clock(stage.groundwork, views, found.seconds - about_s,
                            found.seconds + about_s, believed);
  }
  if (std::ranges::any_of(readings, &Reading::edited)) clock.scanned = found;
  clock.believed_s = nearest_s(found.seconds);
  clock.added_s = clock.error_s > 0 ? found.seconds : clock.believed_s;
  if (clock.error_s > 0 && found.decided)
    clock.error_s = std::max(clock.error_s, std::abs(clock.added_s - clock.believed_s));
  return clock;
}

}  // namespace coppermoon::uses
