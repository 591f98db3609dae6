// SPDX-License-Identifier: MIT
#include "uses/fit/night_clock.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eclipse/contacts.h"
#include "uses/fit/clock_scan.h"

namespace coppermoon::uses {
namespace {

constexpr double half_hour_s = 1800;

/// Range of a clock's correction [s].
struct Possible {
  double from_s, to_s;
};

/// Largest correction of the clock besides half hours, where light is not linear over it [s]; else 0.
double farthest_clock_s(const FitRequest& request) {
  constexpr double linear_s = 300, errors = 3;  // of light beside a moment
  const double error_s = request.clock_error_s;
  return std::max(request.clock_search_s, error_s > linear_s ? errors * error_s : 0);
}

eclipse::Contacts contacts_of(const FitRequest& request) {
  return eclipse::nearest_eclipse(request.photographs.front().instant,
                                  eclipse::ShadowConvention::danjon)
      .contacts;
}

/// First and last correction at which most photographs are of the eclipse.
Possible possible_clocks(const FitRequest& request) {
  if (!request.half_hours_free) return {-farthest_clock_s(request), farthest_clock_s(request)};
  constexpr int farthest = 52;  // half hours: zones are 26 hours apart
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
    throw algebra::Error(
        "no zone and clock explain the photographs' dates: allowed are those of an eclipse");
  return range;
}

/// Some photographs, evenly from the first to the last.
std::vector<std::size_t> some_of(std::size_t all, std::size_t most) {
  const auto count = std::min(most, all);
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < count; ++i)
    indices.push_back(count == 1 ? 0 : i * (all - 1) / (count - 1));
  return indices;
}

/// Correction, in steps of half an hour, at which photographs are most like the Moon: the nearer the shadow is to its
/// place on them, the more alike they are.
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

/// Views of photographs, registered at a correction of the clock.
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
  clock.believed_s = nearest_s(found.seconds);
  clock.added_s = clock.error_s > 0 ? found.seconds : clock.believed_s;
  if (clock.error_s > 0 && found.decided)
    clock.error_s = std::max(clock.error_s, std::abs(clock.added_s - clock.believed_s));
  return clock;
}

}  // namespace coppermoon::uses
