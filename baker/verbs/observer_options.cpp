// SPDX-License-Identifier: MIT
#include "verbs/observer_options.h"

#include <cmath>
#include <vector>

#include "algebra/error.h"
#include "atmosphere/astronomical_refraction.h"
#include "verbs/number_list.h"

namespace coppermoon::verbs {
namespace {

povray_scenes::Up up_from(const std::string& name) {
  if (name == "zenith") return povray_scenes::Up::zenith;
  if (name == "moon-north") return povray_scenes::Up::moon_north;
  return povray_scenes::Up::celestial_north;
}

bool is_up(const almanac::ObserverView& seen) {
  return algebra::in_radians(atmosphere::apparent_altitude(seen.altitude)) > 0;
}

void require_up(const almanac::ObserverView& seen, const ViewOptions& options,
                const almanac::SkyState& sky) {
  if (is_up(seen)) return;
  throw algebra::Error(fmt::format(
      "the Moon is {:.2f} degrees below the horizon of {} at {}, allowed {:.2f}, which refraction "
      "lifts it",
      -algebra::in_degrees(seen.altitude), options.at, almanac::utc_text(sky.when),
      -algebra::in_degrees(atmosphere::lowest_true_altitude)));
}

double flattening_of(const almanac::ObserverView& seen) {
  const double sine = almanac::lunar_radius / seen.moon_distance;
  return atmosphere::refracted_flattening(seen.altitude, algebra::radians(2 * std::asin(sine)));
}

atmosphere::ObserverAir air_over(const almanac::Observer& observer, const ViewOptions& options) {
  atmosphere::ObserverAir air;
  air.ozone_du = options.observer_ozone_du;
  air.aerosol_optical_depth = options.observer_aerosol;
  air.elevation_m = algebra::in_metres(observer.elevation);
  require_valid(air);
  return air;
}

void add_air_options(CLI::App& verb, ViewOptions& options, const std::string& group) {
  add_flag(verb, "--reddening", options.reddening, "by the observer's air, on or off")
      .one_of({"on", "off"})
      .in(group);
  add_flag(verb, "--observer-ozone-du", options.observer_ozone_du,
           "ozone above the observer [DU], 0 to 1000")
      .in(group);
  add_flag(verb, "--observer-aerosol", options.observer_aerosol,
           "vertical optical depth of the aerosol above the observer at 550 nm, 0 to 10")
      .in(group);
  add_flag(verb, "--flattening", options.flattening,
           "of the disc by refraction in the observer's air, on or off")
      .one_of({"on", "off"})
      .in(group);
}

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

void add_view_options(CLI::App& verb, ViewOptions& options) {
  const std::string group = "Who looks, and through what";
  add_flag(verb, "--at", options.at,
           "LAT,LON[,ELEV] of the observer [degrees north, east; m]; without: from the "
           "Earth's centre")
      .in(group);
  add_flag(verb, "--focal-length", options.focal_length_mm,
           "of the telescope or lens [mm]; 1540, or the camera's")
      .in(group);
  add_flag(verb, "--sensor-width", options.sensor_width_mm, "[mm]; 22.7, or the camera's")
      .in(group);
  add_flag(verb, "--field", options.field_deg,
           "angle across the frame [degrees], instead of these two")
      .in(group);
  add_flag(verb, "--width", options.width, "of the frame [pixels]").not_negative().in(group);
  add_flag(verb, "--height", options.height, "of the frame [pixels]").not_negative().in(group);
  add_flag(verb, "--up", options.up, "celestial-north, zenith or moon-north")
      .one_of({"celestial-north", "zenith", "moon-north"})
      .in(group);
  add_air_options(verb, options, group);
}

povray_scenes::HorizonPlace apparent_place(const ViewOptions& options,
                                           const almanac::SkyState& sky) {
  const auto seen = almanac::view_from(observer_from(options.at), sky);
  return {atmosphere::apparent_altitude(seen.altitude), seen.azimuth};
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

bool moon_is_up(const ViewOptions& options, const almanac::SkyState& sky) {
  return options.at.empty() || is_up(almanac::view_from(observer_from(options.at), sky));
}

View view_of(const ViewOptions& options, const almanac::SkyState& sky) {
  const auto field = options.field_deg
                         ? algebra::degrees(*options.field_deg)
                         : povray_scenes::field_of_view(
                               algebra::metres(options.focal_length_mm.value_or(1540) / 1e3),
                               algebra::metres(options.sensor_width_mm.value_or(22.7) / 1e3));
  const auto up = up_from(options.up);
  if (options.at.empty())
    return {povray_scenes::camera_at(sky, up, field, options.width, options.height), {}, {}};
  const auto observer = observer_from(options.at);
  const auto seen = almanac::view_from(observer, sky);
  require_up(seen, options, sky);
  const auto camera =
      options.aim ? povray_scenes::camera_fixed(sky, seen, *options.aim, field, options.width,
                                                options.height)
                  : povray_scenes::camera_at(sky, seen, up, field, options.width, options.height);
  View view{camera, observer, {}};
  if (options.flattening == "on") view.camera.flattening = flattening_of(seen);
  if (options.reddening == "on") view.sightline = {air_over(observer, options), seen.altitude};
  return view;
}

}  // namespace coppermoon::verbs
