// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <chrono>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "end_to_end/random_numbers.h"
#include "end_to_end/true_luminance.h"
#include "support/chance.h"
#include "support/testing.h"
#include "uses/light/moonlight.h"

namespace coppermoon::end_to_end {

struct Run {
  almanac::Instant when;
  uses::LightRequest request;
};

inline const std::vector<eclipse::Eclipse>& eclipses() {
  static const auto all = eclipses_between(
      almanac::instant_from_utc("1990-01-01"), almanac::instant_from_utc("2040-12-31"),
      eclipse::ShadowConvention::danjon, almanac::LunarTheory::moon98);
  return all;
}

inline const eclipse::Eclipse& random_eclipse(Random& random) {
  const auto& all = eclipses();
  return all[static_cast<std::size_t>(random.uniform() * static_cast<double>(all.size()))];
}

/// Some moment of some eclipse, but for its first and last minutes.
inline almanac::Instant random_instant(Random& random) {
  const auto& one = random_eclipse(random);
  const double lasts_s = seconds_between(*one.contacts.P1, *one.contacts.P4);
  return almanac::later(*one.contacts.P1, lasts_s * between(random, 0.02, 0.98));
}

/// Each term of the air as it is in the preset, or anything.
inline uses::Air random_air(Random& random) {
  uses::Air air;
  air.atmosphere = one_of(
      random, std::array<std::string, 5>{"paper", "molecular", "clear", "standard", "standard"});
  auto& column = air.column;
  if (random.uniform() < 0.15) {
    column.danjon = static_cast<int>(5 * random.uniform());
    return air;
  }
  const auto sometimes = [&](const std::function<void()>& change) {
    if (random.uniform() < 0.5) change();
  };
  sometimes([&] { column.ozone_du = between(random, 0, 500); });
  sometimes([&] { column.cloud_cover = between(random, 0, 1); });
  sometimes([&] { column.cloud_top_km = between(random, 0, 15); });
  sometimes([&] { column.tropospheric_optical_depth = between(random, 0, 0.3); });
  sometimes([&] { column.dust_extinction_per_m = log_between(random, 1e-7, 3e-5); });
  sometimes([&] {
    using enum atmosphere::StratosphericAerosol;
    column.stratosphere = one_of(random, std::array{none, background, moderate, high, extreme});
  });
  return air;
}

inline Run random_run(std::uint64_t index) {
  Random random(2008, index);
  Run run{random_instant(random), {}};
  run.request.air = random_air(random);
  run.request.wish.tolerance = log_between(random, 1e-4, 0.1);
  return run;
}

/// Deep in a total eclipse of a spherical Earth, half of it, or a tropic, in a volcano's dust.
inline Run random_run_with_a_region(std::uint64_t index) {
  auto run = random_run(index);
  Random random(1963, index);
  const eclipse::Eclipse* total = nullptr;
  while (total == nullptr || total->type != eclipse::EclipseType::total)
    total = &random_eclipse(random);
  run.when = total->greatest;
  run.request.air = {};
  run.request.air.earth = uses::EarthFigure::sphere;
  const double south = one_of(random, std::array{-90., -30., 0.}), north = south == 0 ? 90 : 0;
  run.request.air.regions = {
      {.from_latitude = south,
       .to_latitude = north,
       .column = {.dust_extinction_per_m = log_between(random, 1e-6, 1e-5)}}};
  return run;
}

inline std::string described(const Run& run) {
  const auto& air = run.request.air;
  const auto& column = air.column;
  std::string text = fmt::format("{} {}", almanac::utc_text(run.when), air.atmosphere);
  const auto say = [&](const char* what, const auto& value) {
    if (value) text += fmt::format(", {} {}", what, *value);
  };
  say("danjon", column.danjon);
  say("ozone [DU]", column.ozone_du);
  say("cloud", column.cloud_cover);
  say("to [km]", column.cloud_top_km);
  say("troposphere", column.tropospheric_optical_depth);
  if (column.stratosphere)
    text += fmt::format(
        ", stratosphere {}",
        static_cast<int>(std::get<atmosphere::StratosphericAerosol>(*column.stratosphere)));
  say("dust", column.dust_extinction_per_m);
  for (const auto& region : air.regions)
    text += fmt::format(", dust {} from {} to {} degrees", *region.column.dust_extinction_per_m,
                        *region.from_latitude, *region.to_latitude);
  return text;
}

/// Places of the lit half on a circle of one depth, by increasing axis distance.
struct Circle {
  double depth_m;
  std::vector<double> distances_m, angles_rad;
};

/// Given  out  of the disc's middle, as the Sun sees it, over its radius
inline Circle circle_on(const uses::ShadowedMoon& moon, double out, std::size_t places,
                        Random& random) {
  const double radius = algebra::in_metres(almanac::lunar_radius),
               away = algebra::in_metres(moon.centre.axis_distance),
               towards = algebra::in_radians(moon.centre.position_angle);
  std::vector<std::pair<double, double>> all;
  for (std::size_t i = 0; i < places; ++i) {
    const double phi = between(random, 0, 2 * std::numbers::pi);
    const double east = away * std::sin(towards) + radius * out * std::cos(phi),
                 north = away * std::cos(towards) + radius * out * std::sin(phi);
    const double degree = std::numbers::pi / 180;  // TrueLuminance
    all.emplace_back(std::hypot(east, north),
                     std::round(std::atan2(east, north) / degree) * degree);
  }
  std::ranges::sort(all);
  Circle circle{algebra::in_metres(moon.centre.depth) - radius * std::sqrt(1 - out * out), {}, {}};
  for (const auto& [distance, angle] : all) {
    circle.distances_m.push_back(distance);
    circle.angles_rad.push_back(angle);
  }
  return circle;
}

/// Evenly over the disc.
inline std::vector<Circle> circles_on(const uses::ShadowedMoon& moon, std::size_t circles,
                                      std::size_t places, std::uint64_t index) {
  Random random(2009, index);
  std::vector<Circle> all;
  for (std::size_t i = 0; i < circles; ++i) {
    const double out =
        std::sqrt((static_cast<double>(i) + random.uniform()) / static_cast<double>(circles));
    all.push_back(circle_on(moon, out, places, random));
  }
  return all;
}

inline double largest_error(const shadow::Lookup& luminance, const TrueLuminance& truth,
                            const std::vector<Circle>& circles) {
  double worst = 0;
  for (const auto& circle : circles) {
    const auto exact = truth.at(circle.depth_m, circle.distances_m, circle.angles_rad);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      std::array<double, 1> found;
      luminance.read({.axis_distance = algebra::metres(circle.distances_m[i]),
                      .position_angle = algebra::radians(circle.angles_rad[i]),
                      .depth = algebra::metres(circle.depth_m)},
                     found);
      if (exact[i] > 0) worst = std::max(worst, std::abs(found[0] / exact[i] - 1));
    }
  }
  return worst;
}

/// An error that nobody can ask for, nor needs to be told: a tenth of the finest tolerance.
inline constexpr double no_error = 1e-5;

struct Result {
  double predicted, found, truth, predicted_s, taken_s;

  bool bounded() const { return truth <= predicted + no_error; }
  bool told() const { return 3 * found + no_error >= truth; }
  bool in_time() const { return taken_s <= 2 * predicted_s && predicted_s <= 2 * taken_s; }
};

inline Result result_of(const Run& run, std::size_t circles, std::size_t places, Truth truth,
                        std::uint64_t index) {
  truth.scattered = scattered_light_of(run.request) != uses::ScatteredLight::off;
  const auto sky = almanac::sky_at(run.when);
  const auto start = std::chrono::steady_clock::now();
  const auto light = light_on_the_moon(run.request, sky);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  const auto moon = shadowed_moon(run.request, sky);
  const double error =
      largest_error(light.in_channels(uses::luminance_weights()), TrueLuminance(moon, truth),
                    circles_on(moon, circles, places, index));
  const Result result{light.plan.error, light.error_found, error, light.plan.seconds,
                      taken.count()};
  if (!result.bounded() || !result.told()) {
    fmt::print("run {}: tolerance {}, predicted {:.2g}, found {:.2g}, true {:.2g}\n  {}\n", index,
               *run.request.wish.tolerance, result.predicted, result.found, result.truth,
               described(run));
    const auto& work = light.plan.work;
    fmt::print("  bands {}, rays {}, sun terms {}, planes {}, place error {}{}{}{}{}\n", work.bands,
               work.rays, work.sun_terms, work.planes, work.place_error,
               work.refracted ? "" : ", no refracted light", work.ellipsoid ? "" : ", sphere",
               work.regions ? "" : ", no regions", work.scattered_light ? ", scattered light" : "");
  }
  return result;
}

inline double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
  return values[values.size() / 2];
}

template <typename Property>
std::ptrdiff_t count(const std::vector<Result>& results, Property property) {
  return std::ranges::count_if(results, property);
}

inline void print(const char* title, const std::vector<Result>& results) {
  std::vector<double> error_ratios, time_ratios;
  for (const auto& result : results) {
    error_ratios.push_back(result.predicted / result.truth);
    time_ratios.push_back(result.predicted_s / result.taken_s);
  }
  fmt::print("| {} | {} |\n", title, results.size());
  fmt::print("| the predicted error bounds the true one | {} |\n",
             count(results, &Result::bounded));
  fmt::print("| predicted over true error, median | {:.2g} |\n", median(error_ratios));
  fmt::print("| the error found is at least a third of the true one | {} |\n",
             count(results, &Result::told));
  fmt::print("| the predicted time is right within a factor of two | {} |\n",
             count(results, &Result::in_time));
  fmt::print("| predicted over taken time, median | {:.2g} |\n", median(time_ratios));
}

}  // namespace coppermoon::end_to_end
