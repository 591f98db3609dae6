// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
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
  uses::NightLights lights;
  almanac::City city;  ///< the place, or the nearest one
  bool own_clocks;     ///< the place is that city
  std::string zone;    ///< time zone of the local times

  const uses::Circumstances& circumstances() const { return lights.night; }
};

constexpr const char* winds[] = {"N", "NNE", "NE", "ENE", "E", "ESE", "SE", "SSE",
                                 "S", "SSW", "SW", "WSW", "W", "WNW", "NW", "NNW"};

std::string wind(algebra::Angle azimuth) {
  const double sixteenths = algebra::in_degrees(azimuth) / 22.5;
  return winds[static_cast<std::size_t>(sixteenths + 16.5) % 16];
}

std::string clock_of(const NightReport& night, const almanac::Instant& when) {
  const auto local = uses::local_time(when, night.zone);
  return almanac::date_in(night.circumstances().eclipse.calendar, local.date) + " " + local.time +
         " " + local.abbreviation;
}

const uses::NightLight* light_of(const NightReport& night, const std::string& name) {
  const auto found = std::ranges::find(night.lights.moments, name, &uses::NightLight::name);
  return found == night.lights.moments.end() ? nullptr : &*found;
}

std::string camera_text(double seconds) {
  const double time = uses::camera_time_s(seconds);
  if (time < 0.29) return fmt::format("1/{:.0f}", 1 / time);
  return time > 30 ? duration(time) : fmt::format("{:g}", time);
}

/// Exposure time as cameras mark it, and that of a brighter and a darker Moon: "2 s (1.6 to 2.5)".
std::string exposure_text(const std::optional<uses::PartExposure>& part) {
  if (!part) return "-";
  const auto time = camera_text(part->time_s), least = camera_text(part->least_s),
             most = camera_text(part->most_s);
  return time + (uses::camera_time_s(part->time_s) > 30 ? "" : " s") +
         (least == most ? "" : fmt::format(" ({} to {})", least, most));
}

/// What limits the times of a phase, as for a reader.
std::string limit_text(const uses::PhaseExposure& phase) {
  std::vector<std::string> limits;
  if (phase.too_dark) limits.emplace_back("too dark");
  if (phase.by_sky) limits.emplace_back("sky");
  double under = 0;
  for (const auto& part : {phase.lit, phase.shadow})
    if (part) under = std::max(under, part->stops_under);
  if (under > 0.05) limits.push_back(fmt::format("trails, {:.1f} stops under", under));
  return fmt::format("{}", fmt::join(limits, "; "));
}

void print_moments(const NightReport& night) {
  fmt::print("{:<12}{:<10}{:<26}{:>9}{:>10}{:>6}{:>9}{:>7}{:>8}{:>11}{:>7}\n", "", "UTC",
             "local time", "altitude", "azimuth", "", "Sun", "limb", "V", "cd/m²", "stars");
  for (const auto& moment : night.circumstances().moments) {
    fmt::print("{:<12}{:<10}{:<26}{:>8.1f}°{:>9.1f}° {:<5}{:>8.1f}°", moment.name,
               almanac::time_of_day_text(moment.when), clock_of(night, moment.when),
               algebra::in_degrees(moment.moon.altitude), algebra::in_degrees(moment.moon.azimuth),
               wind(moment.moon.azimuth), algebra::in_degrees(moment.sun_altitude));
    const auto* light = light_of(night, moment.name);
    const bool seen = is_seen(night.circumstances(), moment.when);
    if (light != nullptr && !seen) fmt::print("   not seen");
    if (light != nullptr && seen)
      fmt::print("{:>7}{:>8.2f}{:>10}{:>7}",
                 moment.position_angle
                     ? fmt::format("{:.0f}°", algebra::in_degrees(*moment.position_angle))
                     : "",
                 light->V_magnitude, three_digits(light->mean_luminance_cd_m2),
                 light->faintest_star ? fmt::format("{:.1f}", *light->faintest_star) : "-");
    fmt::print("\n");
  }
}

/// Phases of an eclipse and how long they last [s], then how long it is seen.
std::vector<std::pair<const char*, double>> durations(const uses::Circumstances& night) {
  const auto& c = night.eclipse.contacts;
  std::vector<std::pair<const char*, double>> all;
  const auto add = [&](const char* name, const auto& from, const auto& to) {
    if (from && to) all.emplace_back(name, almanac::seconds_between(*from, *to));
  };
  add("penumbral", c.P1, c.P4);
  add("partial", c.U1, c.U4);
  add("total", c.U2, c.U3);
  double seen = 0;
  for (const auto& [first, last] : night.seen) seen += almanac::seconds_between(first, last);
  if (seen > 0) all.emplace_back("seen", seen);
  return all;
}

void print_durations(const NightReport& night) {
  std::vector<std::string> texts;
  for (const auto& [name, seconds] : durations(night.circumstances())) {
    const auto minutes = static_cast<int>(std::lround(seconds / 60));
    texts.push_back(fmt::format("{} {} h {:02} min", name, minutes / 60, minutes % 60));
  }
  fmt::print("\nFor how long: {}.\n", fmt::join(texts, ", "));
}

void print_exposures(const NightReport& night) {
  fmt::print("\nExposure times at f/{:.3g}, ISO {:g}:\n{:<34}{:<10}{:<22}{:<24}{}\n",
             night.lights.f_number, night.lights.iso, "", "UTC", "lit part", "part in the umbra",
             "limit");
  bool dark = false, by_sky = false;
  for (const auto& phase : night.lights.exposures) {
    auto line = fmt::format("{:<34}{:<10}", phase.phase, almanac::time_of_day_text(phase.when));
    line += phase.seen ? fmt::format("{:<22}{:<24}{}", exposure_text(phase.lit),
                                     exposure_text(phase.shadow), limit_text(phase))
                       : fmt::format("not seen: the sky is {} times as bright",
                                     three_digits(phase.sky_over_moon));
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
    dark |= phase.too_dark;
    by_sky |= phase.by_sky;
  }
  if (dark) fmt::print("Too dark: the exposure would be longer than the whole eclipse.\n");
  if (by_sky) fmt::print("Sky: its light makes the exposure shorter.\n");
  if (night.lights.trailing_s)
    fmt::print("\nWithout a mount that follows it, the Moon trails by two pixels in {}.\n",
               exposure_in_words(*night.lights.trailing_s));
}

std::string place_name(const NightReport& night) {
  return night.own_clocks ? night.city.name : uses::place_text(night.circumstances().place);
}

void print(const NightReport& night) {
  fmt::print("{}\n{}: {}\n", title(night.circumstances().eclipse), place_name(night),
             what_is_seen(night.circumstances()));
  if (!night.own_clocks && night.zone == uses::time_zone_of(night.circumstances().place))
    fmt::print("{} --zone shows others.\n", uses::whose_clocks(night.circumstances().place));
  fmt::print("\n");
  print_moments(night);
  print_durations(night);
  if (night.circumstances().seen.empty()) return;
  if (night.lights.V_error)
    fmt::print("In totality V is known to {:.2f} mag (68 %).\n", *night.lights.V_error);
  print_exposures(night);
}

nlohmann::ordered_json or_null(const std::optional<double>& number) {
  return number ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}

/// Adds a part's time, its range by the error of the forecast, and what is missing where it would trail.
void add_part(nlohmann::ordered_json& row, const std::string& name,
              const std::optional<uses::PartExposure>& part) {
  row[name + "_s"] = part ? nlohmann::ordered_json(part->time_s) : nlohmann::ordered_json();
  if (!part) return;
  row[name + "_range_s"] = {part->least_s, part->most_s};
  if (part->stops_under > 0) row[name + "_stops_under"] = part->stops_under;
}

nlohmann::ordered_json as_json(const NightReport& night) {
  const auto& place = night.circumstances().place;
  const auto calendar = night.circumstances().eclipse.calendar;
  nlohmann::ordered_json all{{"eclipse", title(night.circumstances().eclipse)},
                             {"at", uses::place_text(place)},
                             {"time_zone", night.zone},
                             {"seen", what_is_seen(night.circumstances())},
                             {"f_number", night.lights.f_number},
                             {"iso", night.lights.iso},
                             {"V_error", or_null(night.lights.V_error)},
                             {"durations_s", nlohmann::ordered_json::object()},
                             {"moments", nlohmann::ordered_json::array()},
                             {"exposures", nlohmann::ordered_json::array()}};
  say_calendar(all, calendar);
  for (const auto& [name, seconds] : durations(night.circumstances()))
    all["durations_s"][name] = seconds;
  for (const auto& moment : night.circumstances().moments) {
    const auto local = uses::local_time(moment.when, night.zone);
    nlohmann::ordered_json row{{"name", moment.name},
                               {"utc", almanac::utc_text(moment.when, calendar)},
                               {"local", almanac::date_in(calendar, local.date) + "T" + local.time},
                               {"zone", local.abbreviation},
                               {"altitude_deg", algebra::in_degrees(moment.moon.altitude)},
                               {"azimuth_deg", algebra::in_degrees(moment.moon.azimuth)},
                               {"up", moment.up},
                               {"seen", is_seen(night.circumstances(), moment.when)},
                               {"sun_altitude_deg", algebra::in_degrees(moment.sun_altitude)},
                               {"twilight", uses::twilight_name(moment.sun_altitude)}};
    if (moment.position_angle)
      row["position_angle_deg"] = algebra::in_degrees(*moment.position_angle);
    if (const auto* light = light_of(night, moment.name)) {
      row["V_magnitude"] = light->V_magnitude;
      row["mean_luminance_cd_m2"] = light->mean_luminance_cd_m2;
      row["faintest_star"] = or_null(light->faintest_star);
      row["sky_cd_m2"] = or_null(light->sky_cd_m2);
    }
    all["moments"].push_back(row);
  }
  for (const auto& phase : night.lights.exposures) {
    nlohmann::ordered_json row{{"phase", phase.phase},
                               {"utc", almanac::utc_text(phase.when, calendar)},
                               {"seen", phase.seen},
                               {"sky_over_moon", phase.sky_over_moon},
                               {"by_sky", phase.by_sky}};
    add_part(row, "lit", phase.lit);
    add_part(row, "umbra", phase.shadow);
    if (phase.too_dark) row["too_dark"] = true;
    all["exposures"].push_back(row);
  }
  if (night.lights.trailing_s) all["trailing_s"] = *night.lights.trailing_s;
  return all;
}

std::string as_csv(const NightReport& night) {
  const auto document = as_json(night);
  std::string text =
      "moment,utc,local,zone,altitude_deg,azimuth_deg,up,V_magnitude,mean_luminance_cd_m2,"
      "faintest_star,seen,sun_altitude_deg,twilight,position_angle_deg\n";
  for (const auto& row : document["moments"]) {
    text += fmt::format("{},{},{},{},{:.3f},{:.3f},{}", row["name"].get<std::string>(),
                        row["utc"].get<std::string>(), row["local"].get<std::string>(),
                        row["zone"].get<std::string>(), row["altitude_deg"].get<double>(),
                        row["azimuth_deg"].get<double>(), row["up"].get<bool>() ? "yes" : "no");
    const auto number = [&](const char* key, const char* form) {
      const auto found = row.find(key);
      return found == row.end() || found->is_null()
                 ? std::string()
                 : fmt::format(fmt::runtime(form), found->template get<double>());
    };
    text +=
        fmt::format(",{},{},{},{},{:.3f},{},{}\n", number("V_magnitude", "{:.3f}"),
                    number("mean_luminance_cd_m2", "{:.6g}"), number("faintest_star", "{:.2f}"),
                    row["seen"].get<bool>() ? "yes" : "no", row["sun_altitude_deg"].get<double>(),
                    row["twilight"].get<std::string>(), number("position_angle_deg", "{:.2f}"));
  }
  return text;
}

const Writers<NightReport>& writers() {
  using Night = NightReport;
  using File = std::filesystem::path;
  constexpr auto map = [](const Night& night, const File& file) {
    uses::write_visibility_map(file, night.circumstances().eclipse, night.circumstances().place);
  };
  static const Writers<Night> all{
      {{".ics", "calendar"},
       [](const Night& night, const File& file) {
         const auto text = as_calendar(night.circumstances(), place_name(night), now());
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

NightReport night_of(const Options& options) {
  auto film = options.film;
  film.zone = options.zone;
  const auto eclipse = eclipse_of(film, options.view.observer);
  const auto named = almanac::city_named(options.place);
  NightReport night{{uses::circumstances(eclipse, *options.view.observer)},
                    named ? *named : almanac::nearest_city(*options.view.observer),
                    named.has_value(),
                    options.zone};
  if (has_ending(options.outputs, ".ics"))
    uses::require_in_calendars({night.circumstances()}, place_name(night));
  if (night.zone.empty() || night.zone == "local")
    night.zone = named ? named->time_zone : uses::time_zone_of(*options.view.observer);
  uses::local_time(eclipse.greatest, night.zone);  // refuses what is no zone
  ProgressBar bar("light");
  auto development = options.develop;
  development.focal_length_mm = seen_through(development.camera, options.view).focal_length_mm;
  night.lights = night_lights(night.circumstances(), moon_request(options.moon), options.view,
                              development, options.danjon, bar.progress());
  if (has_ending(options.outputs, ".ics"))
    uses::require_in_calendars({night.circumstances()}, place_name(night));
  return night;
}

void run(const Options& options) {
  if (!options.view.observer) throw WrongUsage("--at: missing; a place is needed, as Honolulu");
  require_writers(options.outputs, writers(), "a night");
  const auto night = night_of(options);
  say_unless_danjon_is_reached(options.moon.light.request.air,
                               almanac::sky_at(night.circumstances().eclipse.greatest));
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

void add_night(Program& program) {
  using namespace of_night;
  auto& verb = add_verb(program, "night",
                        "plans a night under an eclipse for one place: when and where the Moon "
                        "stands, how bright it is, how to expose it");
  const auto options = std::make_shared<Options>();
  options->moon.light.effort.quality = "draft";
  add_flag(verb, "eclipse,--eclipse", options->film.eclipse, "day of the eclipse, as 2026-03-03")
      .required();
  add_calendar_option(verb, options->film.calendar);
  add_parsed(
      verb, "--at",
      [options](const std::string& text) {
        options->view.observer = uses::observer_from(text);
        options->place = text;
      },
      "place of the observer: a city, as Honolulu, or LAT,LON[,ELEV] [degrees north and east, "
      "metres]");
  add_flag(verb, "--zone", options->zone,
           "time zone of the local times: an IANA name, as Europe/Berlin, or an offset, as +02:00; "
           "default: that of the city");
  add_outputs(verb, options->outputs, writers());
  add_flag(verb,
           request::on_off("--danjon-spread", options->danjon,
                           "exposures of the middle of totality for Danjon's scale 0 to 4 too"));
  add_flag(verb, "--focal-length", options->view.focal_length_mm,
           "focal length of the telescope or lens [mm], 1 to 1e6: no exposure lets the Moon trail "
           "by more "
           "than two pixels, the camera's or 4 um wide, as where no mount follows it")
      .within(1, 1e6);
  add_run_switch(verb, "--csv", options->csv, "prints the moments as CSV").not_beside({{"json"}});
  add_run_switch(verb, "--json", options->json, "prints one JSON document");
  add_map_options(verb, options->moon.request);
  add_light_options(verb, options->moon.light);
  add_described(verb, options->develop, uses::describe_but_time);
  add_described(verb, options->develop.camera);
  for (const char* of_a_picture :
       {"view", "display", "config", "bits", "diffraction", "seeing", "glow", "read-noise",
        "converter-noise", "black-level", "sensor-bits", "noise", "noise-seed", "response"})
    verb.parameters.find(of_a_picture)->only_with({});
  on_run(verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
