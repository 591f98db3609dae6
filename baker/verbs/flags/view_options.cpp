// SPDX-License-Identifier: MIT
#include "verbs/flags/view_options.h"

#include <fmt/format.h>

#include <vector>

#include "algebra/error.h"
#include "verbs/flags/number_list.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* view_group = "Who looks, and through what";

}  // namespace

almanac::Observer observer_from(const std::string& text) {
  const auto numbers = number_list(text).value_or(std::vector<double>{});
  if (numbers.size() < 2 || numbers.size() > 3)
    throw algebra::Error(
        fmt::format("place = {}, allowed LATITUDE,LONGITUDE[,ELEVATION] in degrees (north, east) "
                    "and metres, as 42.86,-73.77",
                    text));
  const almanac::Observer observer{algebra::degrees(numbers[0]), algebra::degrees(numbers[1]),
                                   algebra::metres(numbers.size() == 3 ? numbers[2] : 0)};
  almanac::require_on_earth(observer);
  return observer;
}

povray_scenes::HorizonPlace aim_from(const std::string& text) {
  const auto numbers = number_list(text).value_or(std::vector<double>{});
  if (numbers.size() != 2)
    throw algebra::Error(
        fmt::format("aim = {}, allowed ALTITUDE,AZIMUTH in degrees, as 30,120", text));
  algebra::require_within("altitude of the aim [degrees]", numbers[0], -89, 89);
  algebra::require_within("azimuth of the aim [degrees]", numbers[1], -360, 360);
  return {algebra::degrees(numbers[0]), algebra::degrees(numbers[1])};
}

void add_observer_options(CLI::App& verb, uses::ViewRequest& request) {
  const std::string group = view_group;
  add_parsed(
      verb, "--at", [&](const std::string& text) { request.observer = observer_from(text); },
      "LAT,LON[,ELEV] of the observer [degrees north, east; m]; without: from the "
      "Earth's centre")
      .in(group);
  add_on_off(verb, "--reddening", request.reddening, "by the observer's air, on or off").in(group);
  add_flag(verb, "--observer-ozone-du", request.observer_ozone_du,
           "ozone above the observer [DU], 0 to 1000")
      .in(group);
  add_flag(verb, "--observer-aerosol", request.observer_aerosol,
           "vertical optical depth of the aerosol above the observer at 550 nm, 0 to 10")
      .in(group);
}

void add_view_options(CLI::App& verb, uses::ViewRequest& request) {
  using povray_scenes::Up;
  const std::string group = view_group;
  add_observer_options(verb, request);
  add_on_off(verb, "--flattening", request.flattening,
             "of the disc by refraction in the observer's air, on or off")
      .in(group);
  add_flag(verb, "--focal-length", request.focal_length_mm,
           "of the telescope or lens [mm]; 1540, or the camera's")
      .in(group);
  add_flag(verb, "--sensor-width", request.sensor_width_mm, "[mm]; 22.7, or the camera's")
      .in(group);
  add_flag(verb, "--field", request.field_deg,
           "angle across the frame [degrees], instead of these two")
      .in(group);
  add_flag(verb, "--width", request.width, "of the frame [pixels]").not_negative().in(group);
  add_flag(verb, "--height", request.height, "of the frame [pixels]").not_negative().in(group);
  add_choice<Up>(verb, "--up", request.up,
                 {{"celestial-north", Up::celestial_north},
                  {"zenith", Up::zenith},
                  {"moon-north", Up::moon_north}},
                 "celestial-north, zenith or moon-north")
      .in(group);
}

}  // namespace coppermoon::verbs
