// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/calendar.h"
#include "uses/light/photometric_bands.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/moon_options.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/progress_bar.h"
#include "verbs/reports/report.h"
#include "verbs/reports/writers.h"

namespace coppermoon::verbs {
namespace of_brightness {
namespace {

struct Options {
  MoonOptions moon;
  uses::ViewRequest view;  ///< observer and the air above alone
  std::vector<std::string> outputs;
  bool json = false;
};

/// Magnitudes by the names of their bands.
nlohmann::ordered_json by_band(const std::vector<double>& numbers) {
  const auto bands = uses::photometric_bands();
  nlohmann::ordered_json all;
  for (std::size_t k = 0; k < bands.size(); ++k) all[bands[k].name] = numbers[k];
  return all;
}

nlohmann::ordered_json as_json(const uses::BrightnessSeen& seen, const Options& options) {
  const auto& lost = seen.extinction_mag;
  return {{"at", uses::place_text(*options.view.observer)},
          {"altitude_deg", algebra::in_degrees(seen.moon.altitude)},
          {"azimuth_deg", algebra::in_degrees(seen.moon.azimuth)},
          {"magnitudes", by_band(seen.disc.magnitudes)},
          {"extinction_mag", by_band(lost)},
          {"reddening_b_v", lost[0] - lost[1]},
          {"mean_luminance_cd_m2", seen.disc.mean_luminance_cd_m2},
          {"illuminance_lx", seen.disc.illuminance_lx}};
}

nlohmann::ordered_json described(const Options& options) {
  const auto request = moon_request(options.moon);
  const auto sky = eclipsed_sky(options.moon, options.view.observer);
  ProgressBar bar("light");
  const auto brightness = uses::brightness_of(request, sky, options.view, bar.progress());
  const auto calendar = options.moon.moment.calendar;
  nlohmann::ordered_json all{{"instant", almanac::utc_text(sky.when, calendar)},
                             {"magnitudes", by_band(brightness.disc.magnitudes)},
                             {"V_error", nullptr},
                             {"mean_luminance_cd_m2", brightness.disc.mean_luminance_cd_m2},
                             {"illuminance_lx", brightness.disc.illuminance_lx},
                             {"danjon", nullptr}};
  say_calendar(all, calendar);
  if (brightness.danjon) all["danjon"] = *brightness.danjon;
  if (brightness.V_error) all["V_error"] = *brightness.V_error;
  if (brightness.seen) all["seen"] = as_json(*brightness.seen, options);
  return all;
}

using Json = nlohmann::ordered_json;

/// Rows of one moment: the Moon above the air, and as a place sees it.
std::string as_csv_of(const Json& all) {
  auto rows = Json::array();
  const auto add_row = [&](const Json& disc) {
    auto& row = rows.emplace_back();
    row["instant"] = all["instant"];
    for (const char* key : {"altitude_deg", "azimuth_deg"}) row[key] = disc.value(key, Json());
    for (const auto& [band, magnitude] : disc["magnitudes"].items())
      row[band + "_magnitude"] = magnitude;
    for (const char* key : {"V_error", "danjon"}) row[key] = all[key];
    for (const char* key : {"mean_luminance_cd_m2", "illuminance_lx"}) row[key] = disc[key];
  };
  add_row(all);
  if (all.contains("seen")) add_row(all["seen"]);
  return as_csv(rows);
}

const Writers<Json>& writers() {
  using File = std::filesystem::path;
  static const Writers<Json> all{
      {{".csv", "table"},
       [](const Json& told, const File& file) { files::write_whole(file, as_csv_of(told)); }},
      {{".json", "JSON document"},
       [](const Json& told, const File& file) { files::write_whole(file, told.dump(2) + "\n"); }}};
  return all;
}

void print_light(const nlohmann::ordered_json& disc) {
  fmt::print("mean luminance  {:>8} cd/m²\n",
             three_digits(disc["mean_luminance_cd_m2"].get<double>()));
  fmt::print("illuminance     {:8.3g} lx, on a surface that faces the Moon\n",
             disc["illuminance_lx"].get<double>());
}

void print_seen(const nlohmann::ordered_json& seen) {
  fmt::print("\nas seen from {}, {:.1f} degrees above the horizon\n", seen["at"].get<std::string>(),
             seen["altitude_deg"].get<double>());
  for (const auto& [band, magnitude] : seen["magnitudes"].items())
    fmt::print("{}               {:8.2f} mag, dimmed by {:.2f}\n", band, magnitude.get<double>(),
               seen["extinction_mag"][band].get<double>());
  print_light(seen);
}

void run(const Options& options) {
  if (has_ending(options.outputs, ".ics"))
    throw WrongUsage("--output: night and almanac write calendars (.ics); brightness writes " +
                     files::in_words(writers()));
  require_writers(options.outputs, writers(), "a list of magnitudes");
  auto all = described(options);
  write_files(all, options.outputs, writers());
  if (options.json) {
    if (!options.outputs.empty()) all["files"] = options.outputs;
    fmt::print("{}\n", all.dump(2));
    return;
  }
  for (const auto& [band, magnitude] : all["magnitudes"].items())
    fmt::print("{}               {:8.2f} mag{}\n", band, magnitude.get<double>(),
               band == "V" && !all["V_error"].is_null()
                   ? fmt::format(" ± {:.2f} (68 %)", all["V_error"].get<double>())
                   : "");
  print_light(all);
  if (all["danjon"].is_null())
    fmt::print("Danjon                 - (not in totality)\n");
  else
    fmt::print("Danjon          {:8.1f}\n", all["danjon"].get<double>());
  if (all.contains("seen")) print_seen(all["seen"]);
  print_names(options.outputs);
}

}  // namespace
}  // namespace of_brightness

void add_brightness(CLI::App& program) {
  using namespace of_brightness;
  auto* verb = add_verb(program, "brightness",
                        "computes magnitudes, mean luminance and illuminance of the whole Moon, "
                        "above the air and seen from a place");
  const auto options = std::make_shared<Options>();
  add_moon_options(*verb, options->moon);
  add_described(*verb, options->view, uses::describe_observer);
  add_outputs(*verb, options->outputs, writers());
  add_run_switch(*verb, "--json", options->json, "prints one JSON document");
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
