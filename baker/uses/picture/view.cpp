// SPDX-License-Identifier: MIT
#include "uses/picture/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "atmosphere/astronomical_refraction.h"

namespace coppermoon::uses {
namespace {

bool is_up(const almanac::ObserverView& seen) {
  return algebra::in_radians(atmosphere::apparent_altitude(seen.altitude)) > 0;
}

void require_up(const almanac::ObserverView& seen, const almanac::Observer& observer,
                const almanac::SkyState& sky) {
  if (is_up(seen)) return;
  throw algebra::Error(fmt::format(
      "the Moon is {:.2f} degrees below the horizon of {} at {}, allowed {:.2f}, which refraction "
      "lifts it",
      -algebra::in_degrees(seen.altitude), place_text(observer), almanac::utc_text(sky.when),
      -algebra::in_degrees(atmosphere::lowest_true_altitude)));
}

double flattening_of(const almanac::ObserverView& seen) {
  const double sine = almanac::lunar_radius / seen.moon_distance;
  return atmosphere::refracted_flattening(seen.altitude, algebra::radians(2 * std::asin(sine)));
}

/// Across the frame: what is told, or else so that the shorter side takes in the largest Moon there is,
/// 0.57 degrees from where it stands in the zenith at its nearest, with some margin.
algebra::Angle field_of(const ViewRequest& request) {
  if (request.field_deg) return algebra::degrees(*request.field_deg);
  if (request.focal_length_mm || request.sensor_width_mm)
    return povray_scenes::field_of_view(
        algebra::metres(request.focal_length_mm.value_or(paper_focal_length_mm) / 1e3),
        algebra::metres(request.sensor_width_mm.value_or(paper_sensor_width_mm) / 1e3));
  constexpr double shorter_rad = 0.6 * std::numbers::pi / 180;
  const auto side = [](std::size_t pixels) {  // one that is out of range is refused later
    return std::clamp(static_cast<double>(pixels), 1., 65535.);
  };
  const double across = side(request.width) / std::min(side(request.width), side(request.height));
  return algebra::radians(2 * std::atan(across * std::tan(shorter_rad / 2)));
}

atmosphere::ObserverAir air_over(const almanac::Observer& observer, const ViewRequest& request) {
  atmosphere::ObserverAir air;
  air.ozone_du = request.observer_ozone_du;
  air.aerosol_optical_depth = request.observer_aerosol;
  air.elevation_m = algebra::in_metres(observer.elevation);
  require_valid(air);
  return air;
}

}  // namespace

std::string place_text(const almanac::Observer& observer) {
  const double elevation_m = algebra::in_metres(observer.elevation);
  return fmt::format("{:.7g},{:.7g}{}", algebra::in_degrees(observer.latitude),
                     algebra::in_degrees(observer.longitude),
                     elevation_m == 0 ? "" : fmt::format(",{:g}", elevation_m));
}

povray_scenes::HorizonPlace apparent_place(const almanac::Observer& observer,
                                           const almanac::SkyState& sky) {
  const auto seen = almanac::view_from(observer, sky);
  return {atmosphere::apparent_altitude(seen.altitude), seen.azimuth};
}

bool moon_is_up(const ViewRequest& request, const almanac::SkyState& sky) {
  return !request.observer || is_up(almanac::view_from(*request.observer, sky));
}

View view_of(const ViewRequest& request, const almanac::SkyState& sky) {
  const povray_scenes::Picture picture{field_of(request), request.width, request.height};
  if (request.stars.faintest)
    algebra::require_within("magnitude of the faintest star", *request.stars.faintest, -5, 20);
  if (!request.observer)
    return {povray_scenes::camera_at(sky, request.up, picture), {}, {}, request.stars};
  const auto& observer = *request.observer;
  const auto seen = almanac::view_from(observer, sky);
  require_up(seen, observer, sky);
  const auto camera = request.aim ? povray_scenes::camera_fixed(sky, seen, *request.aim, picture)
                                  : povray_scenes::camera_at(sky, seen, request.up, picture);
  View view{camera, observer, {}, request.stars, request.flattening};
  if (request.flattening) view.camera.flattening = flattening_of(seen);
  if (request.reddening) view.sightline = {air_over(observer, request), seen.altitude};
  return view;
}

}  // namespace coppermoon::uses
