// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/calendar.h"
#include "uses/film/film_times.h"
#include "uses/light/photometric_bands.h"
#include "uses/picture/curve_plot.h"
#include "uses/picture/local_time.h"
#include "uses/picture/picture_parameters.h"
#include "verbs/command_line.h"
#include "verbs/flags/film_options.h"
#include "verbs/flags/moon_options.h"
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
  std::string from, to;    ///< of a light curve; both empty: one moment
  double step_min = 5;
  std::vector<std::string> outputs;
  bool json = false, csv = false;

  bool over_time() const { return !from.empty() || !to.empty(); }
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

/// Brightness of one moment, or of many.
struct Told {
  Json all;
  uses::LightCurve curve = {};  ///< without moments: of one moment
  eclipse::Eclipse eclipse = {};
  std::string place = {};
};

std::string as_csv_of(const Told& told) {
  return told.curve.moments.empty() ? as_csv_of(told.all) : as_csv(told.all["moments"]);
}

uses::FilmTimes times_of(const Options& options) {
  FilmOptions film{.eclipse = options.moon.moment.text};
  if (!options.from.empty()) film.from = options.from;
  if (!options.to.empty()) film.to = options.to;
  film.calendar = options.moon.moment.calendar;
  film.zone = options.moon.moment.zone;
  return verbs::times_of(film, options.view);
}

/// Rows of a curve, with local time where a zone is asked for. What is not known, or is infinite, is null.
Json rows_of(const uses::LightCurve& curve, const Options& options) {
  auto rows = Json::array();
  const auto& [text, calendar, asked] = options.moon.moment;
  const bool of_place = asked == "local" && options.view.observer;
  const auto zone = of_place ? uses::time_zone_of(*options.view.observer) : asked;
  for (std::size_t i = 0; i < curve.moments.size(); ++i) {
    auto& row = rows.emplace_back();
    row["instant"] = almanac::utc_text(curve.moments[i], calendar);
    if (!zone.empty()) {
      const auto local = uses::local_time(curve.moments[i], zone);
      row["local"] = almanac::date_in(calendar, local.date) + "T" + local.time;
    }
    for (const auto& [name, numbers] : curve.columns)
      row[name] = std::isfinite(numbers[i]) ? Json(numbers[i]) : Json();
  }
  return rows;
}

Told told_over_time(const Options& options) {
  const auto request = moon_request(options.moon);
  const auto times = times_of(options);
  const auto moments = uses::moments_between(times.from, times.to, options.step_min);
  say_unless_danjon_is_reached(request.light.air, almanac::sky_at(times.eclipse.greatest));
  ProgressBar bar("light");
  Told told{{}, uses::light_curve(request, moments, options.view, bar.progress()), times.eclipse};
  told.all["eclipse"] = title(times.eclipse);
  if (options.view.observer) {
    told.place = uses::place_text(*options.view.observer);
    told.all["at"] = told.place;
  }
  say_calendar(told.all, options.moon.moment.calendar);
  told.all["moments"] = rows_of(told.curve, options);
  return told;
}

const Writers<Told>& writers() {
  using File = std::filesystem::path;
  static const Writers<Told> all = [] {
    Writers<Told> formats{
        {{".csv", "table"},
         [](const Told& told, const File& file) { files::write_whole(file, as_csv_of(told)); }},
        {{".json", "JSON document"}, [](const Told& told, const File& file) {
           files::write_whole(file, told.all.dump(2) + "\n");
         }}};
    for (const auto& format : uses::plot_files())
      formats.push_back(
          {{format.ending, "plot of a light curve"}, [](const Told& told, const File& file) {
             uses::write_plot(file, plot_of(told.curve, told.eclipse, told.place));
           }});
    return formats;
  }();
  return all;
}

/// Refuses a plot of one moment.
void require_curve_for_plots(const Options& options) {
  if (options.over_time()) return;
  for (const auto& format : uses::plot_files())
    if (has_ending(options.outputs, format.ending))
      throw WrongUsage(
          fmt::format("--output: a plot ({}) shows a light curve, allowed with --from "
                      "or --to",
                      format.ending));
}

void print_rows(const Json& moments) {
  const auto number = [](const Json& row, const char* key) {
    return row[key].is_null() ? NAN : row[key].get<double>();
  };
  for (const auto& row : moments) {
    fmt::print("{}  V {:6.2f}  {:9.3g} cd/m²  {:9.3g} lx", row["instant"].get<std::string>(),
               number(row, "V_magnitude"), number(row, "mean_luminance_cd_m2"),
               number(row, "illuminance_lx"));
    if (row.contains("altitude_deg"))
      fmt::print("   seen at {:4.1f}°: V {:6.2f}  {:9.3g} lx", number(row, "altitude_deg"),
                 number(row, "seen_V_magnitude"), number(row, "seen_illuminance_lx"));
    fmt::print("\n");
  }
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
  require_curve_for_plots(options);
  auto told = options.over_time() ? told_over_time(options) : Told{described(options)};
  auto& all = told.all;
  write_files(told, options.outputs, writers());
  if (options.json) {
    if (!options.outputs.empty()) all["files"] = options.outputs;
    fmt::print("{}\n", all.dump(2));
    return;
  }
  if (options.csv) return fmt::print("{}", as_csv_of(told));
  if (options.over_time()) {
    print_rows(all["moments"]);
    return print_names(options.outputs);
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

void add_brightness(Program& program) {
  using namespace of_brightness;
  auto& verb = add_verb(program, "brightness",
                        "computes magnitudes, mean luminance and illuminance of the whole Moon, "
                        "above the air and seen from a place, at a moment or over time");
  const auto options = std::make_shared<Options>();
  add_moon_options(verb, options->moon);
  add_described(verb, options->view, uses::describe_observer);
  add_flag(verb, "--from", options->from,
           "first moment of a light curve, a time or a contact, as P1 or U2-10min, or moonrise; "
           "default: P1 where --to is given");
  add_flag(verb, "--to", options->to,
           "last moment of a light curve, a time or a contact, as P4, or moonset; default: P4 "
           "where --from is given");
  add_flag(verb, "--step", options->step_min,
           "minutes between the moments of a light curve, 0.01 to 1440")
      .within(0.01, 1440)
      .only_with({{"from"}, {"to"}});
  add_outputs(verb, options->outputs, writers());
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  add_run_switch(verb, "--csv", options->csv, "prints a table as CSV").not_beside({{"json"}});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
