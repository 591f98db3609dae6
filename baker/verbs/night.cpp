// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "almanac/gazetteer.h"
#include "files/whole_file.h"
#include "uses/film/film_times.h"
#include "uses/night/calendar_file.h"
#include "uses/night/night_light.h"
#include "uses/night/visibility_map.h"
#include "uses/picture/local_time.h"
#include "uses/picture/picture_parameters.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/camera_options.h"
#include "verbs/flags/film_options.h"
#include "verbs/flags/moments.h"
#include "verbs/flags/moon_options.h"
#include "verbs/recipes/recipe.h"
#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"
#include "verbs/reports/progress_bar.h"
#include "verbs/reports/writers.h"

namespace coppermoon::verbs {
namespace of_night {
namespace {

struct Options {
  FilmOptions film;  ///< eclipse and calendar alone
  MoonOptions moon;
  uses::ViewRequest view;
  uses::Development develop;
  std::string place, zone;  ///< of the local times; empty: the zone of the place
  std::vector<std::string> outputs;
  bool danjon = true, json = false, csv = false;
};

/// Night of an eclipse at one place: what the command prints.
struct NightReport {
  uses::Circumstances circumstances;
  uses::NightLights lights;
  almanac::City city;  ///< the place, or the nearest one
  bool own_clocks;     ///< the place is that city
  std::string zone;    ///< time zone of the local times
  /// Time in which the Moon trails by two pixels; none where no focal length is given.
  std::optional<double> trailing_s = {};
};

constexpr const char* winds[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                 "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};

std::string wind(algebra::Angle azimuth) {
  const double sixteenths = algebra::in_degrees(azimuth) / 22.5;
  return winds[static_cast<std::size_t>(sixteenths + 16.5) % 16];
}

std::string clock_of(const NightReport& night, const almanac::Instant& when) {
  const auto local = uses::local_time(when, night.zone);
  return almanac::date_in(night.circumstances.eclipse.calendar, local.date) + " " + local.time +
         " " + local.abbreviation;
}

const uses::NightLight* light_of(const NightReport& night, const std::string& name) {
  const auto found = std::ranges::find(night.lights.moments, name, &uses::NightLight::name);
  return found == night.lights.moments.end() ? nullptr : &*found;
}

/// Exposure time as cameras mark it.
std::string exposure_text(const std::optional<double>& seconds, bool too_dark) {
  if (!seconds) return too_dark ? "- (too dark)" : "-";
  const double time = uses::camera_time_s(*seconds);
  if (time < 0.29) return fmt::format("1/{:.0f} s", 1 / time);
  return time > 30 ? duration(time) : fmt::format("{:g} s", time);
}

void print_moments(const NightReport& night) {
  fmt::print("{:<10}{:<10}{:<26}{:>9}{:>10}{:>6}{:>8}{:>12}{:>7}\n", "", "UTC", "local time",
             "altitude", "azimuth", "", "V", "cd/m²", "stars");
  for (const auto& moment : night.circumstances.moments) {
    fmt::print("{:<10}{:<10}{:<26}{:>8.1f}°{:>9.1f}° {:<5}", moment.name,
               almanac::time_of_day_text(moment.when), clock_of(night, moment.when),
               algebra::in_degrees(moment.moon.altitude), algebra::in_degrees(moment.moon.azimuth),
               wind(moment.moon.azimuth));
    const auto* light = light_of(night, moment.name);
    if (light != nullptr && moment.up)
      fmt::print("{:>8.2f}{:>11}{:>7}", light->V_magnitude,
                 three_digits(light->mean_luminance_cd_m2),
                 light->faintest_star ? fmt::format("{:.1f}", *light->faintest_star) : "-");
    else if (light != nullptr)
      fmt::print("   not seen");
    fmt::print("\n");
  }
}

void print_exposures(const NightReport& night) {
  fmt::print("\nExposure times at f/{:.3g}, ISO {:g}:\n{:<34}{:>12}{:>22}\n", night.lights.f_number,
             night.lights.iso, "", "lit part", "part in the umbra");
  for (const auto& exposure : night.lights.exposures)
    fmt::print("{:<34}{:>12}{:>22}\n", exposure.phase,
               exposure_text(exposure.lit_s, exposure.too_dark),
               exposure_text(exposure.shadow_s, exposure.too_dark));
  if (std::ranges::any_of(night.lights.exposures, &uses::PhaseExposure::too_dark))
    fmt::print("Too dark: the exposure would be longer than the whole eclipse.\n");
  if (night.trailing_s)
    fmt::print("\nWithout a mount that follows it, the Moon trails by two pixels in {}.\n",
               exposure_in_words(*night.trailing_s));
}

std::string place_name(const NightReport& night) {
  return night.own_clocks ? night.city.name : uses::place_text(night.circumstances.place);
}

void print(const NightReport& night) {
  fmt::print("{}\n{}: {}\n", title(night.circumstances.eclipse), place_name(night),
             what_is_seen(night.circumstances));
  if (!night.own_clocks && night.zone == uses::time_zone_of(night.circumstances.place))
    fmt::print("{} --zone shows others.\n", uses::whose_clocks(night.circumstances.place));
  fmt::print("\n");
  print_moments(night);
  if (night.lights.V_error)
    fmt::print("\nIn totality V is known to {:.2f} mag (68 %).\n", *night.lights.V_error);
  print_exposures(night);
}

nlohmann::ordered_json or_null(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}

nlohmann::ordered_json as_json(const NightReport& night) {
  const auto& place = night.circumstances.place;
  const auto calendar = night.circumstances.eclipse.calendar;
  nlohmann::ordered_json all{{"eclipse", title(night.circumstances.eclipse)},
                             {"at", uses::place_text(place)},
                             {"time_zone", night.zone},
                             {"seen", what_is_seen(night.circumstances)},
                             {"f_number", night.lights.f_number},
                             {"iso", night.lights.iso},
                             {"V_error", or_null(night.lights.V_error)},
                             {"moments", nlohmann::ordered_json::array()},
                             {"exposures", nlohmann::ordered_json::array()}};
  say_calendar(all, calendar);
  for (const auto& moment : night.circumstances.moments) {
    const auto local = uses::local_time(moment.when, night.zone);
    nlohmann::ordered_json row{{"name", moment.name},
                               {"utc", almanac::utc_text(moment.when, calendar)},
                               {"local", almanac::date_in(calendar, local.date) + "T" + local.time},
                               {"zone", local.abbreviation},
                               {"altitude_deg", algebra::in_degrees(moment.moon.altitude)},
                               {"azimuth_deg", algebra::in_degrees(moment.moon.azimuth)},
                               {"up", moment.up}};
    if (const auto* light = light_of(night, moment.name)) {
      row["V_magnitude"] = light->V_magnitude;
      row["mean_luminance_cd_m2"] = light->mean_luminance_cd_m2;
      row["faintest_star"] = or_null(light->faintest_star);
    }
    all["moments"].push_back(row);
  }
  for (const auto& exposure : night.lights.exposures) {
    all["exposures"].push_back({{"phase", exposure.phase},
                                {"utc", almanac::utc_text(exposure.when, calendar)},
                                {"lit_s", or_null(exposure.lit_s)},
                                {"umbra_s", or_null(exposure.shadow_s)}});
    if (exposure.too_dark) all["exposures"].back()["too_dark"] = true;
  }
  if (night.trailing_s) all["trailing_s"] = *night.trailing_s;
  return all;
}

std::string as_csv(const NightReport& night) {
  const auto document = as_json(night);
  std::string text =
      "moment,utc,local,zone,altitude_deg,azimuth_deg,up,V_magnitude,mean_luminance_cd_m2,"
      "faintest_star\n";
  for (const auto& row : document["moments"]) {
    text += fmt::format("{},{},{},{},{:.3f},{:.3f},{}", row["name"].get<std::string>(),
                        row["utc"].get<std::string>(), row["local"].get<std::string>(),
                        row["zone"].get<std::string>(), row["altitude_deg"].get<double>(),
                        row["azimuth_deg"].get<double>(), row["up"].get<bool>() ? "yes" : "no");
    if (!row.contains("V_magnitude")) {
      text += ",,,\n";
      continue;
    }
    const auto& star = row["faintest_star"];
    text += fmt::format(",{:.3f},{:.6g},{}\n", row["V_magnitude"].get<double>(),
                        row["mean_luminance_cd_m2"].get<double>(),
                        star.is_null() ? "" : fmt::format("{:.2f}", star.get<double>()));
  }
  return text;
}

const Writers<NightReport>& writers() {
  using Night = NightReport;
  using File = std::filesystem::path;
  constexpr auto map = [](const Night& night, const File& file) {
    uses::write_visibility_map(file, night.circumstances.eclipse, night.circumstances.place);
  };
  static const Writers<Night> all{
      {{".ics", "calendar"},
       [](const Night& night, const File& file) {
         const auto text = as_calendar(night.circumstances, place_name(night), now());
         files::write_whole(file, text);
       }},
      {{".csv", "moments"},
       [](const Night& night, const File& file) { files::write_whole(file, as_csv(night)); }},
      {{".json", "moments and exposures"},
       [](const Night& night, const File& file) {
         files::write_whole(file, as_json(night).dump(2) + "\n");
       }},
      {{".png", "map of where the eclipse is seen"}, map},
      {{".svg", "the same"}, map},
      {{".pdf", "the same"}, map}};
  return all;
}

/// Time in which the Moon trails by two pixels of the camera, without one of 4 µm.
double trailing_s(const uses::Circumstances& night, const Options& options) {
  constexpr double usual_pixel_um = 4;
  const auto camera = uses::camera_of(options.develop.camera);
  return uses::trailing_time_s(night, *options.view.focal_length_mm,
                               2 * (camera ? camera->sensor.pixel_um : usual_pixel_um));
}

NightReport night_of(const Options& options) {
  auto film = options.film;
  film.zone = options.zone;
  const auto eclipse = eclipse_of(film, options.view.observer);
  if (has_ending(options.outputs, ".ics")) uses::require_in_calendars({eclipse});
  const auto named = almanac::city_named(options.place);
  NightReport night{uses::circumstances(eclipse, *options.view.observer),
                    {},
                    named ? *named : almanac::nearest_city(*options.view.observer),
                    named.has_value(),
                    options.zone};
  if (night.zone.empty() || night.zone == "local")
    night.zone = named ? named->time_zone : uses::time_zone_of(*options.view.observer);
  uses::local_time(eclipse.greatest, night.zone);  // refuses what is no zone
  if (options.view.focal_length_mm) night.trailing_s = trailing_s(night.circumstances, options);
  ProgressBar bar("light");
  auto development = options.develop;
  development.focal_length_mm = seen_through(development.camera, options.view).focal_length_mm;
  night.lights = night_lights(night.circumstances, moon_request(options.moon), options.view,
                              development, options.danjon, bar.progress());
  return night;
}

void run(const Options& options) {
  if (!options.view.observer) throw WrongUsage("--at: missing; a place is needed, as Honolulu");
  require_writers(options.outputs, writers(), "a night");
  const auto night = night_of(options);
  say_unless_danjon_is_reached(options.moon.light.request.air,
                               almanac::sky_at(night.circumstances.eclipse.greatest));
  write_files(night, options.outputs, writers());
  if (options.json) {
    auto document = as_json(night);
    if (!options.outputs.empty()) document["files"] = options.outputs;
    return fmt::print("{}\n", document.dump(2));
  }
  if (options.csv) return fmt::print("{}", as_csv(night));
  print(night);
  print_names(options.outputs);
}

}  // namespace
}  // namespace of_night

void add_night(CLI::App& program) {
  using namespace of_night;
  auto* verb = add_verb(program, "night",
                        "plans a night under an eclipse for one place: when and where the Moon "
                        "stands, how bright it is, how to expose it");
  const auto options = std::make_shared<Options>();
  options->moon.light.effort.quality = "draft";
  add_flag(*verb, "eclipse,--eclipse", options->film.eclipse, "day of the eclipse, as 2026-03-03")
      .required();
  add_calendar_option(*verb, options->film.calendar);
  add_parsed(
      *verb, "--at",
      [options](const std::string& text) {
        options->view.observer = uses::observer_from(text);
        options->place = text;
      },
      "place of the observer: a city, as Honolulu, or LAT,LON[,ELEV] [degrees north and east, "
      "metres]");
  add_flag(*verb, "--zone", options->zone,
           "time zone of the local times: an IANA name, as Europe/Berlin, or an offset, as +02:00; "
           "default: that of the city");
  add_outputs(*verb, options->outputs, writers());
  add_flag(*verb,
           request::on_off("--danjon-spread", options->danjon,
                           "exposures of the middle of totality for Danjon's scale 0 to 4 too"));
  add_flag(
      *verb, "--focal-length", options->view.focal_length_mm,
      "focal length of the telescope or lens [mm], 1 to 1e6: adds in what time the Moon trails "
      "by two pixels, the camera's or 4 um wide, where no mount follows it")
      .within(1, 1e6);
  add_run_switch(*verb, "--csv", options->csv, "prints the moments as CSV").not_beside({{"json"}});
  add_run_switch(*verb, "--json", options->json, "prints one JSON document");
  add_map_options(*verb, options->moon.request);
  add_light_options(*verb, options->moon.light);
  add_described(*verb, options->develop, uses::describe_but_time);
  add_described(*verb, options->develop.camera);
  for (const char* of_a_picture :
       {"view", "display", "config", "bits", "diffraction", "seeing", "glow", "read-noise",
        "converter-noise", "black-level", "sensor-bits", "noise", "noise-seed", "response"})
    parameters_of(*verb).find(of_a_picture)->only_with({});
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
