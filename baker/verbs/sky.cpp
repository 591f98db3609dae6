// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "almanac/calendar.h"
#include "almanac/observer.h"
#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "uses/picture/place_text.h"
#include "verbs/command_line.h"
#include "verbs/flags/moments.h"
#include "verbs/recipes/recipe.h"

namespace coppermoon::verbs {
namespace {

using algebra::in_degrees;
using algebra::in_kilometres;

struct Options {
  MomentOptions moment;
  std::string at;
  bool json = false;
};

void add_view(nlohmann::ordered_json& all, const std::string& at, const almanac::SkyState& sky) {
  const auto view = almanac::view_from(uses::observer_from(at), sky);
  all["altitude_deg"] = in_degrees(view.altitude);
  all["azimuth_deg"] = in_degrees(view.azimuth);
  all["parallactic_angle_deg"] = in_degrees(view.parallactic_angle);
  all["observer_moon_distance_km"] = in_kilometres(view.moon_distance);
  all["sub_observer_latitude_deg"] = in_degrees(view.sub_observer.latitude);
  all["sub_observer_longitude_deg"] = in_degrees(view.sub_observer.longitude);
}

nlohmann::ordered_json described(const Options& options) {
  const auto sky = almanac::sky_at(instant_of(options.moment));
  const auto moon = almanac::equatorial_place(sky, sky.moon_m);
  const auto shadow = eclipse::place_in_shadow(eclipse::shadow_axis(sky), sky.moon_m);
  nlohmann::ordered_json all{
      {"instant", almanac::utc_text(sky.when, options.moment.calendar, 3)},
      {"delta_t_s", almanac::delta_t_s(sky.when)},
      {"moon_ra_deg", in_degrees(moon.right_ascension)},
      {"moon_dec_deg", in_degrees(moon.declination)},
      {"moon_distance_km", in_kilometres(moon.distance)},
      {"sun_distance_au", glm::length(sky.sun_m) / almanac::astronomical_unit_m},
      {"sub_earth_latitude_deg", in_degrees(sky.sub_earth.latitude)},
      {"sub_earth_longitude_deg", in_degrees(sky.sub_earth.longitude)},
      {"sub_solar_latitude_deg", in_degrees(sky.sub_solar.latitude)},
      {"sub_solar_longitude_deg", in_degrees(sky.sub_solar.longitude)},
      {"axis_position_angle_deg", in_degrees(sky.axis_position_angle)},
      {"axis_distance_km", in_kilometres(shadow.axis_distance)}};
  say_calendar(all, options.moment.calendar);
  if (!options.at.empty()) add_view(all, options.at, sky);
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
  add_switch(*verb, "--json", options->json, "prints one JSON document")
      .of(request::Affects::run);
  add_recipe_option(*verb);
  on_run(*verb, [options] { run(*options); });
}

}  // namespace coppermoon::verbs
