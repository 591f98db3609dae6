// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "eclipse/sky_columns.h"
#include "uses/picture/place_text.h"
#include "uses/picture/sky_lights.h"
#include "uses/picture/view.h"
#include "verbs/command_line.h"
#include "verbs/flags/moments.h"

namespace coppermoon::verbs {
namespace of_sky {
namespace {

struct Options {
  MomentOptions moment;
  std::string at;
  std::optional<double> faintest_star;
  bool json = false;
};

template <class Result>
void add(nlohmann::ordered_json& all, const std::vector<algebra::Column<Result>>& columns,
         const Result& result) {
  for (const auto& column : columns) all[column.name] = column.value(result);
}

/// Adds the stars' places as an observer's air raises them.
void add_stars(nlohmann::ordered_json& all, const almanac::Observer& observer, double faintest,
               const almanac::SkyState& sky) {
  all["observer_latitude_deg"] = in_degrees(observer.latitude);
  all["stars"] = nlohmann::json::array();
  const auto view =
      uses::view_of({.observer = observer, .stars = {.shown = true, .faintest = faintest}}, sky);
  for (const auto& star : uses::lights_over(view, sky))
    all["stars"].push_back({{"altitude_deg", in_degrees(star.place.altitude)},
                            {"azimuth_deg", in_degrees(star.place.azimuth)},
                            {"illuminance_lux", star.illuminance_lux}});
}

nlohmann::ordered_json described(const Options& options) {
  std::optional<almanac::Observer> observer;
  if (!options.at.empty()) observer = uses::observer_from(options.at);
  const auto sky = almanac::sky_at(instant_of(options.moment, observer));
  const auto calendar = options.moment.calendar;
  nlohmann::ordered_json all{{"instant", almanac::utc_text(sky.when, calendar, 3)}};
  add(all, eclipse::sky_columns(), sky);
  say_calendar(all, calendar);
  if (!observer) return all;
  add(all, eclipse::view_columns(), almanac::view_from(*observer, sky));
  if (options.faintest_star) add_stars(all, *observer, *options.faintest_star, sky);
  return all;
}

void run(const Options& options) {
  if (options.faintest_star && (options.at.empty() || !options.json))
    throw algebra::Error("stars are listed with --at and --json");
  const auto all = described(options);
  if (options.json) {
    fmt::print("{}\n", all.dump(2));
    return;
  }
  for (const auto& [key, value] : all.items())
    fmt::print(
        "{:<30}{}\n", key,
        value.is_number() ? fmt::format("{:.6f}", value.get<double>()) : value.get<std::string>());
}

}  // namespace
}  // namespace of_sky

void add_sky(Program& program) {
  using namespace of_sky;
  auto& verb =
      add_verb(program, "sky", "says where Sun, Moon and shadow are, and how the Moon is turned");
  const auto options = std::make_shared<Options>();
  add_moment_options(verb, options->moment).required();
  add_flag(verb, "--at", options->at,
           "place of an observer: a city, as Chicago, or LAT,LON[,ELEV] [degrees north and east, "
           "metres]");
  add_flag(verb, "--stars", options->faintest_star,
           "V magnitude, -5 to 20: lists stars and planets to it; illuminance in linear Rec.709")
      .within(-5, 20)
      .of(request::Affects::run);
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
