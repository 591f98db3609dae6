// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/calendar.h"
#include "eclipse/sky_columns.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/moments.h"
#include "verbs/recipes/recipe.h"

namespace coppermoon::verbs {
namespace {

struct Options {
  MomentOptions moment;
  std::string at;
  bool json = false;
};

template <class Result>
void add(nlohmann::ordered_json& all, const std::vector<algebra::Column<Result>>& columns,
         const Result& result) {
  for (const auto& column : columns) all[column.name] = column.value(result);
}

nlohmann::ordered_json described(const Options& options) {
  const auto sky = almanac::sky_at(instant_of(options.moment));
  const auto calendar = options.moment.calendar;
  nlohmann::ordered_json all{{"instant", almanac::utc_text(sky.when, calendar, 3)}};
  add(all, eclipse::sky_columns(), sky);
  say_calendar(all, calendar);
  if (!options.at.empty())
    add(all, eclipse::view_columns(), almanac::view_from(uses::observer_from(options.at), sky));
  return all;
}

void run(const Options& options) {
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

void add_sky(CLI::App& program) {
  auto* verb =
      add_verb(program, "sky", "says where Sun, Moon and shadow are, and how the Moon is turned");
  const auto options = std::make_shared<Options>();
  add_moment_options(*verb, options->moment).required();
  add_flag(*verb, "--at", options->at,
           "place of an observer: a city, as Chicago, or LAT,LON[,ELEV] [degrees north and east, "
           "metres]");
  add_run_switch(*verb, "--json", options->json, "prints one JSON document");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
