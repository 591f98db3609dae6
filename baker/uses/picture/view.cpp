// SPDX-License-Identifier: MIT
#include "uses/picture/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <utility>

#include "algebra/error.h"
#include "almanac/gazetteer.h"
#include "atmosphere/astronomical_refraction.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::uses {
namespace {

algebra::Angle semidiameter(const almanac::ObserverView& seen) {
  return algebra::radians(std::asin(almanac::lunar_radius / seen.moon_distance));
}

algebra::Angle limb_above_horizon(const almanac::Observer& observer,
                                  const almanac::ObserverView& seen) {
  return seen.altitude + semidiameter(seen) - horizon_altitude(observer);
}

/// Name of the city whose coordinates are those of the place; if there is none, the coordinates.
std::string place_name(const almanac::Observer& observer) {
  const auto city = almanac::nearest_city(observer);
  const bool same = place_text(city.place) == place_text(observer);
  return same ? city.name : place_text(observer);
}

void require_up(const almanac::ObserverView& seen, const almanac::Observer& observer) {
  const double below_deg = -algebra::in_degrees(limb_above_horizon(observer, seen));
  if (below_deg < 0) return;
  throw algebra::Error(
      fmt::format("from {} the Moon is {:.{}f}° below the horizon then; choose another moment or "
                  "place, or none",
                  place_name(observer), below_deg, below_deg < 10 ? 1 : 0));
}

/// The Moon's altitude, but at least that of an object on the apparent horizon, where the model of the air ends. From a
/// high place, the Moon may be seen lower.
algebra::Angle altitude_in_air(const almanac::ObserverView& seen) {
  return std::max(seen.altitude, atmosphere::lowest_true_altitude);
}

double flattening_of(const almanac::ObserverView& seen) {
  return atmosphere::refracted_flattening(altitude_in_air(seen), 2 * semidiameter(seen));
}

/// Field across the frame: as given or, by default, wide enough for the shorter side to span 0.6 degrees. The largest
/// possible Moon, at its nearest and in the zenith, is 0.57 degrees wide.
algebra::Angle field_of(const ViewRequest& request) {
  if (request.field_deg) return algebra::degrees(*request.field_deg);
  if (request.focal_length_mm || request.sensor_width_mm) {
    const double focal_length_mm = request.focal_length_mm.value_or(paper_focal_length_mm),
                 sensor_width_mm = request.sensor_width_mm.value_or(paper_sensor_width_mm);
    algebra::require_within("focal length [mm]", focal_length_mm, 1, 1e6);
    algebra::require_within("sensor width [mm]", sensor_width_mm, 0.1, 1000);
    return povray_scenes::field_of_view(algebra::metres(focal_length_mm / 1e3),
                                        algebra::metres(sensor_width_mm / 1e3));
  }
  constexpr double shorter_rad = 0.6 * std::numbers::pi / 180;
  const auto side = [](std::size_t pixels) {  // a side that is out of range is refused later
    return std::clamp(static_cast<double>(pixels), 1., 65535.);
  };
  const double across = side(request.width) / std::min(side(request.width), side(request.height));
  return algebra::radians(2 * std::atan(across * std::tan(shorter_rad / 2)));
}

using almanac::Instant;

constexpr double step_s = 1800;

/// Height of the Moon's upper limb above the horizon [rad]. Far from the horizon, a quicker lunar theory is used.
double height(const almanac::Observer& place, const Instant& when) {
  constexpr double far = 0.02;  // [rad]; in 2000 BC the theories differ by a third of this
  using enum almanac::LunarTheory;
  const auto by = [&](almanac::LunarTheory theory) {
    return algebra::in_radians(above_horizon(place, almanac::sky_at(when, theory)));
  };
  const double quick = by(moon98);
  return std::abs(quick) > far ? quick : by(elp_2000_82b);
}

/// The moonrise or moonset within an interval: the moment of height 0, found to within 0.02 s by bisection.
Crossing crossing(const almanac::Observer& place, Instant from, double seconds) {
  const bool up = height(place, from) > 0;
  while (seconds > 0.02) {
    seconds /= 2;
    const auto middle = almanac::later(from, seconds);
    if ((height(place, middle) > 0) == up) from = middle;
  }
  return {from, !up};
}

/// Times [s from the first moment] and the Moon's heights [rad]: every half hour, and at extremes so near the horizon
/// that both a rise and a set may lie within one step.
std::vector<std::pair<double, double>> heights(const almanac::Observer& place, const Instant& from,
                                               double seconds) {
  constexpr double grazing = 3e-3;  // [rad]; half-hourly heights miss extremes by up to 2.1e-3 rad
  const auto steps = static_cast<int>(std::ceil(seconds / step_s));
  const double step = seconds / steps;
  const auto at = [&](double s) { return std::pair{s, height(place, almanac::later(from, s))}; };
  std::vector<std::pair<double, double>> all;
  for (int i = 0; i <= steps; ++i) all.push_back(at(i * step));
  for (int i = 1; i < steps; ++i) {
    const auto n = static_cast<std::size_t>(i);
    const double before = all[n - 1].second, here = all[n].second, after = all[n + 1].second;
    const double bend = before - 2 * here + after;
    if (std::abs(here) < grazing && (here - before) * (here - after) > 0)
      all.push_back(at(i * step + step * (before - after) / (2 * bend)));
  }
  std::ranges::sort(all);
  return all;
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

algebra::Angle horizon_altitude(const almanac::Observer& observer) {
  const double elevation_m = std::max(algebra::in_metres(observer.elevation), 0.);
  return algebra::degrees(-(34 + 2.12 * std::sqrt(elevation_m)) / 60);
}

algebra::Angle above_horizon(const almanac::Observer& observer, const almanac::SkyState& sky) {
  return limb_above_horizon(observer, almanac::view_from(observer, sky));
}

bool moon_is_up(const ViewRequest& request, const almanac::SkyState& sky) {
  return !request.observer || algebra::in_radians(above_horizon(*request.observer, sky)) > 0;
}

glm::dmat3 axes_as_seen(const View& view, const almanac::SkyState& sky) {
  const auto seen = almanac::view_from(*view.observer, sky);
  const auto level = glm::cross(sky.moon_m - seen.position_m, seen.zenith),
             east = glm::normalize(glm::cross(seen.north, seen.zenith));
  const double refraction = algebra::in_radians(atmosphere::apparent_altitude(seen.altitude) -
                                                seen.altitude),
               across = glm::length(level);
  const glm::dmat3 axes{east, glm::cross(seen.zenith, east), seen.zenith};
  if (across == 0) return sky.selenographic_from_gcrs * axes;
  return sky.selenographic_from_gcrs * glm::mat3_cast(glm::angleAxis(-refraction, level / across)) *
         axes;
}

void hide_below_horizon(texture::Image& frame, const View& view, const almanac::SkyState& sky) {
  if (!view.observer) return;
  const auto zenith = axes_as_seen(view, sky)[2];
  const double horizon =
      algebra::in_radians(atmosphere::apparent_altitude(horizon_altitude(*view.observer)));
  const auto altitude = [&](const glm::dvec3& ray) {
    return std::asin(std::clamp(glm::dot(ray, zenith) / glm::length(ray), -1., 1.));
  };
  const auto sight = povray_scenes::sight_of(view.camera);
  const auto middle = sight.corner + 0.5 * static_cast<double>(frame.width) * sight.across +
                      0.5 * static_cast<double>(frame.height) * sight.down;
  const double reach = std::atan2(glm::length(sight.corner - middle), glm::length(middle));
  if (altitude(middle) - reach > horizon) return;
  const double pixel = glm::length(sight.across);
  for (std::size_t row = 0; row < frame.height; ++row)
    for (std::size_t column = 0; column < frame.width; ++column) {
      const auto ray = sight.corner + (static_cast<double>(column) + 0.5) * sight.across +
                       (static_cast<double>(row) + 0.5) * sight.down;
      const double pixels = (altitude(ray) - horizon) * glm::length(ray) / pixel,
                   share = std::clamp(0.5 + pixels, 0., 1.);
      for (std::size_t k = 0; share < 1 && k < frame.channels.size(); ++k)
        frame(row, column, k) *= static_cast<float>(share);
    }
}

atmosphere::ObserverAir air_over(const almanac::Observer& observer, const ViewRequest& request) {
  atmosphere::ObserverAir air;
  air.ozone_du = request.observer_ozone_du;
  air.aerosol_optical_depth = request.observer_aerosol;
  air.elevation_m = algebra::in_metres(observer.elevation);
  require_valid(air);
  return air;
}

View view_of(const ViewRequest& request, const almanac::SkyState& sky) {
  const povray_scenes::Picture picture{field_of(request), request.width, request.height};
  if (request.stars.faintest)
    algebra::require_within("magnitude of the faintest star", *request.stars.faintest, -5, 20);
  if (!request.observer)
    return {.camera = povray_scenes::camera_at(sky, request.up, picture),
            .observer = {},
            .sightline = {},
            .stars = request.stars,
            .sky_cd_m2 = request.sky_cd_m2};
  const auto& observer = *request.observer;
  const auto seen = almanac::view_from(observer, sky);
  require_up(seen, observer);
  const auto camera = request.aim ? povray_scenes::camera_fixed(sky, seen, *request.aim, picture)
                                  : povray_scenes::camera_at(sky, seen, request.up, picture);
  View view{camera,           observer,           {},
            request.stars,    request.flattening, air_over(observer, request),
            request.sky_cd_m2};
  if (request.flattening) view.camera.flattening = flattening_of(seen);
  if (request.reddening) view.sightline = {view.air, altitude_in_air(seen)};
  return view;
}

std::vector<Crossing> horizon_crossings(const almanac::Observer& place, const Instant& from,
                                        const Instant& to) {
  std::vector<Crossing> found;
  const auto all = heights(place, from, almanac::seconds_between(from, to));
  for (std::size_t i = 1; i < all.size(); ++i)
    if ((all[i - 1].second > 0) != (all[i].second > 0))
      found.push_back(
          crossing(place, almanac::later(from, all[i - 1].first), all[i].first - all[i - 1].first));
  return found;
}

}  // namespace coppermoon::uses
