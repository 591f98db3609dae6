// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "almanac/gazetteer.h"
#include "files/whole_file.h"
#include "result/as_json.h"
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
  FilmOptions film;  ///< only its eclipse and calendar are used
  MoonOptions moon;
  uses::ViewRequest view;
  uses::Development develop;
  std::string place, zone;  ///< `zone` is for local times; if empty, the place's zone is used
  std::vector<std::string> outputs;
  bool danjon = true, json = false, csv = false;
};

/// What the command prints about the night of an eclipse at one place.
struct NightReport {
  uses::NightLights lights;
  almanac::City city;       ///< city at the observer's place, or the nearest city
  bool own_clocks = false;  ///< whether the user named the place as a city
  std::string zone;         ///< time zone for local times

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

/// Exposure time as cameras show it, such as "2 s (1.6 to 2.5)". The range is for a brighter or darker Moon.
std::string exposure_text(const std::optional<uses::PartExposure>& part) {
  if (!part) return "-";
  const auto time = camera_text(part->time_s), least = camera_text(part->least_s),
             most = camera_text(part->most_s);
  return time + (uses::camera_time_s(part->time_s) > 30 ? "" : " s") +
         (least == most ? "" : fmt::format(" ({} to {})", least, most));
}

/// Describes in words what limits the exposure times in a phase of the eclipse.
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

/// Durations of an eclipse's phases, and of the time during which the eclipse is seen [s].
algebra::ByName<double> durations(const uses::Circumstances& night) {
  const auto& c = night.eclipse.contacts;
  algebra::ByName<double> all;
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

/// A moment of the night as it is listed in JSON and CSV.
struct MomentRow {
  uses::NightMoment moment;
  uses::LocalTime local;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  bool seen = false;
  std::optional<uses::NightLight> light;  ///< light at that moment; absent for moonrise and moonset
};

template <class Field>
void describe(Field&& is, const MomentRow& row) {
  namespace unit = algebra::unit;
  const auto& moment = row.moment;
  const auto& local = row.local;
  const auto of_light = [&](auto value) { return algebra::of_any(row.light, value); };
  using Light = uses::NightLight;
  is.a("Moment", "A contact, moonrise or moonset, the greatest phase, or the first or last seen.");
  is("name", moment.name, "its name");
  is("utc", moment.when, "the moment, UTC");
  is(
      "local", [&] { return almanac::date_in(row.calendar, local.date) + "T" + local.time; },
      "the same on local clocks");
  is("zone", local.abbreviation, "abbreviation of their time zone");
  is("altitude_deg", moment.moon.altitude, unit::degrees, "altitude of the Moon, with refraction");
  is("azimuth_deg", moment.moon.azimuth, unit::degrees,
     "azimuth of the Moon, from north through east");
  is("up", moment.up, "whether some of the Moon is above the horizon");
  is("seen", row.seen, "whether the Moon stands out from its sky");
  is("sun_altitude_deg", moment.sun_altitude, unit::degrees,
     "altitude of the Sun, without refraction");
  is("twilight", uses::twilight_name(moment.sun_altitude), "light of the sky by that altitude");
  is("position_angle_deg", algebra::if_any(algebra::in_degrees(moment.position_angle)),
     unit::degrees, "place of a contact at the Moon's limb, from celestial north through east");
  is("V_magnitude", of_light([](const Light& one) { return one.V_magnitude; }), unit::mag,
     "V magnitude of the whole Moon, above the air");
  is("mean_luminance_cd_m2", of_light([](const Light& one) { return one.mean_luminance_cd_m2; }),
     unit::luminance, "luminance, the mean over the disc, above the air");
  is("faintest_star", of_light([](const Light& one) { return one.faintest_star; }), unit::mag,
     "V magnitude of the faintest star to the naked eye");
  is("sky_cd_m2", of_light([](const Light& one) { return one.sky_cd_m2; }), unit::luminance,
     "luminance of the sky at the Moon; none of a Moon that is not up");
}

std::vector<MomentRow> rows_of(const NightReport& night) {
  const auto& all = night.circumstances();
  std::vector<MomentRow> rows;
  for (const auto& moment : all.moments) {
    rows.push_back({moment,
                    uses::local_time(moment.when, night.zone),
                    all.eclipse.calendar,
                    is_seen(all, moment.when),
                    {}});
    if (const auto* light = light_of(night, moment.name)) rows.back().light = *light;
  }
  return rows;
}

template <class Field>
void describe(Field&& is, const NightReport& night) {
  namespace unit = algebra::unit;
  const auto& all = night.circumstances();
  is.a("Night", "The night of an eclipse at a place.");
  is(
      "eclipse", [&] { return title(all.eclipse); }, "the eclipse");
  is(
      "at", [&] { return uses::place_text(all.place); },
      "the place: latitude, longitude, elevation");
  is("time_zone", night.zone, "time zone of the local times");
  is(
      "seen", [&] { return what_is_seen(all); }, "sentence about how much of the eclipse is seen");
  is("f_number", night.lights.f_number, "f-number of the exposures");
  is("iso", night.lights.iso, "ISO speed of the exposures");
  is("V_error", night.lights.V_error, unit::mag, "standard error of V in totality");
  is(
      "durations_s", [&] { return durations(all); }, unit::seconds,
      "for how long, by phase: penumbral, partial, total, seen");
  is(
      "moments", [&] { return rows_of(night); }, "the moments, in order of time");
  is("exposures", night.lights.exposures, "exposure times for phases of the eclipse");
  is("trailing_s", algebra::if_any(night.lights.trailing_s), unit::seconds,
     "time in which the Moon trails by two pixels, where a focal length is given");
}

result::Json as_json(const NightReport& night) {
  const auto calendar = night.circumstances().eclipse.calendar;
  auto all = result::as_json(night, {calendar});
  say_calendar(all, calendar);
  return all;
}

std::string as_csv(const NightReport& night) {
  return result::as_csv(rows_of(night), {night.circumstances().eclipse.calendar});
}

std::string as_calendar(const NightReport& night) {
  return uses::as_calendar(night.circumstances(), place_name(night), now());
}

const Writers<NightReport>& writers() {
  constexpr auto map = [](const NightReport& night, const std::filesystem::path& file) {
    uses::write_visibility_map(file, night.circumstances().eclipse, night.circumstances().place);
  };
  static const Writers<NightReport> all{writer_of({".ics", "calendar"}, as_calendar),
                                        writer_of({".csv", "moments"}, as_csv),
                                        writer_of({".json", "moments and exposures"}, as_json),
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
  uses::local_time(eclipse.greatest, night.zone);  // throws if the time zone is unknown
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
  if (options.json) return print_json(as_json(night), options.outputs);
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
  add_json_switch(verb, options->json, {result::fields_of<NightReport>});
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
