// SPDX-License-Identifier: MIT
#include "uses/picture/brightness.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <optional>

#include "almanac/calendar.h"
#include "result/as_json.h"
#include "uses/film/film_times.h"
#include "uses/light/photometer.h"
#include "uses/picture/local_time.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/plots.h"
#include "verbs/command_line.h"
#include "verbs/flags/film_options.h"
#include "verbs/flags/moon_options.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/progress_bar.h"
#include "verbs/reports/writers.h"

namespace coppermoon::verbs {
namespace of_brightness {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  MoonOptions moon;
  uses::ViewRequest view;  ///< only its observer and the air above the observer are used
  std::string from, to;    ///< first and last moment of a light curve; both empty for one moment
  double step_min = 5;
  std::vector<std::string> outputs;
  bool json = false, csv = false;

  bool over_time() const { return !from.empty() || !to.empty(); }
};

/// The Moon's brightness at one moment, as a row of a table: seen from a place if `seen` is set, else above the air.
struct Row {
  const uses::MoonBrightness& moon;
  const uses::BrightnessSeen* seen;
};

template <class Field>
void describe(Field&& is, const Row& row) {
  namespace unit = algebra::unit;
  using Degrees = std::optional<algebra::Angle>;
  const auto& [moon, seen] = row;
  const auto& disc = seen ? seen->disc : moon.disc;
  is.a("Row", "The whole Moon above the air, then as a place sees it.");
  is("instant", moon.instant, "the moment, UTC");
  is("altitude_deg", seen ? Degrees(seen->moon.altitude) : Degrees(), unit::degrees, "altitude");
  is("azimuth_deg", seen ? Degrees(seen->moon.azimuth) : Degrees(), unit::degrees, "azimuth");
  uses::describe_magnitude_columns(is, &disc, "", "");
  is("V_error", moon.V_error, unit::mag, "standard error of V");
  is("danjon", moon.danjon, "step of Danjon's scale");
  uses::describe_light(is, disc);
}

/// A light curve of the Moon, with its eclipse and the place from which the Moon is seen.
struct Curve {
  eclipse::Eclipse eclipse;
  std::optional<std::string> place;
  uses::LightCurve light;
};

template <class Field>
void describe(Field&& is, const Curve& curve) {
  is.a("Curve", "The whole Moon over time.");
  is("eclipse", title(curve.eclipse), "the eclipse");
  is("at", algebra::if_any(curve.place), "the place: latitude, longitude, elevation");
  is("moments", curve.light.moments, "the moments, in order of time");
}

/// Result of the command: brightness either at one moment or over time.
struct Told {
  std::optional<uses::MoonBrightness> moment;
  std::optional<Curve> curve;
  almanac::Calendar calendar;
};

Json as_json(const Told& told) {
  const result::Style style{told.calendar};
  auto all =
      told.curve ? result::as_json(*told.curve, style) : result::as_json(*told.moment, style);
  say_calendar(all, told.calendar);
  return all;
}

std::string as_csv(const Told& told) {
  const result::Style style{told.calendar};
  if (told.curve) return result::as_csv(result::json_of(told.curve->light.moments, style));
  const auto& moment = *told.moment;
  std::vector<Row> rows{{moment, nullptr}};
  if (moment.seen) rows.push_back({moment, &*moment.seen});
  return result::as_csv(result::json_of(rows, style));
}

uses::MoonBrightness at_a_moment(const Options& options) {
  const auto request = moon_request(options.moon);
  const auto sky = eclipsed_sky(options.moon, options.view.observer);
  ProgressBar bar("light");
  return uses::brightness_of(request, sky, options.view, bar.progress());
}

uses::FilmTimes times_of(const Options& options) {
  FilmOptions film{.eclipse = options.moon.moment.text};
  if (!options.from.empty()) film.from = options.from;
  if (!options.to.empty()) film.to = options.to;
  film.calendar = options.moon.moment.calendar;
  film.zone = options.moon.moment.zone;
  return verbs::times_of(film, options.view);
}

/// Adds local times to a light curve if the user asked for a time zone.
void add_local_times(uses::LightCurve& curve, const Options& options) {
  const auto& [text, calendar, asked] = options.moon.moment;
  const bool of_place = asked == "local" && options.view.observer;
  const auto zone = of_place ? uses::time_zone_of(*options.view.observer) : asked;
  if (zone.empty()) return;
  for (auto& [brightness, of_a_place, local] : curve.moments) {
    const auto clock = uses::local_time(brightness.instant, zone);
    local = almanac::date_in(calendar, clock.date) + "T" + clock.time;
  }
}

Curve over_time(const Options& options) {
  const auto request = moon_request(options.moon);
  const auto times = times_of(options);
  const auto moments = uses::moments_between(times.from, times.to, options.step_min);
  say_unless_danjon_is_reached(request.light.air, almanac::sky_at(times.eclipse.greatest));
  ProgressBar bar("light");
  Curve curve{times.eclipse, {}, uses::light_curve(request, moments, options.view, bar.progress())};
  if (options.view.observer) curve.place = uses::place_text(*options.view.observer);
  add_local_times(curve.light, options);
  return curve;
}

const Writers<Told>& writers() {
  static const Writers<Told> all = [] {
    Writers<Told> formats{writer_of({".csv", "table"}, as_csv),
                          writer_of({".json", "JSON document"}, as_json)};
    for (const auto& format : uses::plot_files())
      formats.push_back({{format.ending, "plot of a light curve"},
                         [](const Told& told, const std::filesystem::path& file) {
                           const auto& [eclipse, place, light] = *told.curve;
                           uses::write_plot(file, plot_of(light, eclipse, place.value_or("")));
                         }});
    return formats;
  }();
  return all;
}

/// Throws if a plot is requested for a single moment.
void require_curve_for_plots(const Options& options) {
  if (options.over_time()) return;
  for (const auto& format : uses::plot_files())
    if (has_ending(options.outputs, format.ending))
      throw WrongUsage(
          fmt::format("--output: a plot ({}) shows a light curve, allowed with --from "
                      "or --to",
                      format.ending));
}

void print(const uses::LightCurve& curve, almanac::Calendar calendar) {
  for (const auto& [brightness, of_place, local] : curve.moments) {
    const auto& disc = brightness.disc;
    fmt::print("{}  V {:6.2f}  {:9.3g} cd/m²  {:9.3g} lx",
               almanac::utc_text(brightness.instant, calendar), disc.magnitudes[uses::V_band],
               disc.mean_luminance_cd_m2, disc.illuminance_lx);
    if (const auto& seen = brightness.seen)
      fmt::print("   seen at {:4.1f}°: V {:6.2f}  {:9.3g} lx", in_degrees(seen->moon.altitude),
                 seen->disc.magnitudes[uses::V_band], seen->disc.illuminance_lx);
    fmt::print("\n");
  }
}

void print_light(const uses::DiscBrightness& disc) {
  fmt::print("mean luminance  {:>8} cd/m²\n", three_digits(disc.mean_luminance_cd_m2));
  fmt::print("illuminance     {:8.3g} lx, on a surface that faces the Moon\n", disc.illuminance_lx);
}

void print(const uses::BrightnessSeen& seen) {
  fmt::print("\nas seen from {}, {:.1f} degrees above the horizon\n", uses::place_text(seen.place),
             in_degrees(seen.moon.altitude));
  const auto dimmed = uses::by_band(seen.extinction_mag);
  for (std::size_t k = 0; k < dimmed.size(); ++k)
    fmt::print("{}               {:8.2f} mag, dimmed by {:.2f}\n", dimmed[k].first,
               seen.disc.magnitudes[k], dimmed[k].second);
  print_light(seen.disc);
}

void print(const uses::MoonBrightness& moment) {
  for (const auto& [band, magnitude] : uses::by_band(moment.disc.magnitudes))
    fmt::print(
        "{}               {:8.2f} mag{}\n", band, magnitude,
        band == "V" && moment.V_error ? fmt::format(" ± {:.2f} (68 %)", *moment.V_error) : "");
  print_light(moment.disc);
  if (moment.danjon)
    fmt::print("Danjon          {:8.1f}\n", *moment.danjon);
  else
    fmt::print("Danjon                 - (not in totality)\n");
  if (moment.seen) print(*moment.seen);
}

void run(const Options& options) {
  if (has_ending(options.outputs, ".ics"))
    throw WrongUsage("--output: night and almanac write calendars (.ics); brightness writes " +
                     files::in_words(writers()));
  require_writers(options.outputs, writers(), "a list of magnitudes");
  require_curve_for_plots(options);
  Told told{{}, {}, options.moon.moment.calendar};
  if (options.over_time())
    told.curve = over_time(options);
  else
    told.moment = at_a_moment(options);
  write_files(told, options.outputs, writers());
  if (options.json) return print_json(as_json(told), options.outputs);
  if (options.csv) return fmt::print("{}", as_csv(told));
  if (told.curve)
    print(told.curve->light, told.calendar);
  else
    print(*told.moment);
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
  add_json_switch(verb, options->json,
                  {result::fields_of<uses::MoonBrightness>, result::fields_of<Curve>});
  add_run_switch(verb, "--csv", options->csv, "prints a table as CSV").not_beside({{"json"}});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
