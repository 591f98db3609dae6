// SPDX-License-Identifier: MIT
#include "povray_scenes/scene_camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <numbers>

#include "algebra/error.h"
#include "atmosphere/astronomical_refraction.h"

namespace coppermoon::povray_scenes {
namespace {

using algebra::require_within;

glm::dvec3 celestial_north(const almanac::SkyState& sky) {
  return glm::transpose(sky.equator_from_gcrs) * glm::dvec3(0, 0, 1);
}

glm::dvec3 place_of(const almanac::SkyState& sky, const glm::dvec3& position_m) {
  return sky.selenographic_from_gcrs *
         ((position_m - sky.moon_m) / in_metres(almanac::lunar_radius));
}

SceneCamera looking_from(const almanac::SkyState& sky, const glm::dvec3& position_m,
                         const glm::dvec3& up_gcrs, Up up, SceneCamera camera) {
  camera.position = place_of(sky, position_m);
  camera.up = up == Up::moon_north ? glm::dvec3(0, 0, 1) : sky.selenographic_from_gcrs * up_gcrs;
  require_sound(camera);
  return camera;
}

/// The direction in GCRS axes to an altitude and azimuth in the observer's sky.
glm::dvec3 direction_of(const HorizonPlace& place, const almanac::ObserverView& view) {
  const glm::dvec3 east = glm::normalize(glm::cross(view.north, view.zenith));
  const glm::dvec3 north = glm::cross(view.zenith, east);
  const double altitude = in_radians(place.altitude), azimuth = in_radians(place.azimuth);
  return std::cos(altitude) * (std::cos(azimuth) * north + std::sin(azimuth) * east) +
         std::sin(altitude) * view.zenith;
}

/// The rotation from the Moon's apparent direction to its direction without refraction.
glm::dmat3 without_refraction(const glm::dvec3& moon, const glm::dvec3& zenith) {
  const glm::dvec3 level = glm::cross(moon, zenith);
  const double across = glm::length(level);
  if (across == 0) return glm::dmat3(1);
  const auto altitude = algebra::radians(std::atan2(glm::dot(moon, zenith), across));
  const double refraction = in_radians(atmosphere::apparent_altitude(altitude) - altitude);
  // FAULT refraction that lowers the Moon: glm::angleAxis(-refraction => glm::angleAxis(refraction
  return glm::mat3_cast(glm::angleAxis(-refraction, level / across));
}

}  // namespace

algebra::Angle field_of_view(algebra::Length focal_length, algebra::Length sensor_width) {
  constexpr double least = std::numeric_limits<double>::min(), most = 1e9;
  require_within("focal length [m]", in_metres(focal_length), least, most);
  require_within("sensor width [m]", in_metres(sensor_width), least, most);
  return algebra::radians(2 * std::atan(0.5 * (sensor_width / focal_length)));
}

SceneCamera camera_at(const almanac::SkyState& sky, const almanac::ObserverView& view, Up up,
                      const Picture& picture) {
  SceneCamera camera{{}, {}, picture.field, picture.width, picture.height};
  camera.zenith = sky.selenographic_from_gcrs * view.zenith;
  return looking_from(sky, view.position_m, up == Up::zenith ? view.zenith : celestial_north(sky),
                      up, camera);
}

SceneCamera camera_at(const almanac::SkyState& sky, Up up, const Picture& picture) {
  if (up == Up::zenith)
    throw algebra::Error(
        "up = zenith, which the Earth's centre has not: celestial-north or moon-north");
  return looking_from(sky, {0, 0, 0}, celestial_north(sky), up,
                      {{}, {}, picture.field, picture.width, picture.height});
}

SceneCamera camera_fixed(const almanac::SkyState& sky, const almanac::ObserverView& view,
                         const HorizonPlace& aim, const Picture& picture) {
  require_within("altitude of the aim [degrees]", in_degrees(aim.altitude), -90, 90);
  require_within("azimuth of the aim [degrees]", in_degrees(aim.azimuth), -360, 360);
  const glm::dmat3 from_apparent =
      sky.selenographic_from_gcrs * without_refraction(sky.moon_m - view.position_m, view.zenith);
  SceneCamera camera{place_of(sky, view.position_m), from_apparent * view.zenith, picture.field,
                     picture.width, picture.height};
  camera.zenith = sky.selenographic_from_gcrs * view.zenith;
  camera.direction = from_apparent * direction_of(aim, view);
  require_sound(camera);
  return camera;
}

glm::dvec3 line_of_sight(const SceneCamera& camera) {
  const bool at_centre = camera.direction == glm::dvec3(0, 0, 0);
  return glm::normalize(at_centre ? -camera.position : camera.direction);
}

glm::dmat3 flattened_by_air(const SceneCamera& camera) {
  require_sound(camera);
  const glm::dvec3 sight = glm::normalize(camera.position);
  const glm::dvec3 across = camera.zenith - glm::dot(camera.zenith, sight) * sight;
  const double squared = glm::dot(across, across);
  if (squared == 0) return glm::dmat3(1);
  return glm::dmat3(1) + (camera.flattening - 1) / squared * glm::outerProduct(across, across);
}

std::optional<glm::dvec2> pixel_of(const SceneCamera& camera,
                                   const almanac::SelenographicPoint& place) {
  const glm::dvec3 on_sphere = almanac::selenographic_direction(place);
  const glm::dvec3 at = flattened_by_air(camera) * on_sphere;
  if (glm::dot(on_sphere, camera.position) <= 1) return std::nullopt;
  const glm::dvec3 forward = line_of_sight(camera);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const glm::dvec3 upward = glm::cross(right, forward);
  const double half_width = 0.5 * static_cast<double>(camera.width);
  const double half_height = 0.5 * static_cast<double>(camera.height);
  const glm::dvec3 seen = at - camera.position;
  const double depth = glm::dot(seen, forward);
  if (depth <= 0) return std::nullopt;
  const double scale = half_width / std::tan(0.5 * in_radians(camera.horizontal_field)) / depth;
  const double x = scale * glm::dot(seen, right);
  // FAULT pictures upside down: half_height - scale => half_height + scale
  return glm::dvec2(half_width + x, half_height - scale * glm::dot(seen, upward));
}

void require_sound(const SceneCamera& camera) {
  const double distance = glm::length(camera.position);
  require_within("distance of the camera [lunar radii]", distance, 1 + 1e-9, 1e6);
  require_within("field of view [degrees]", in_degrees(camera.horizontal_field), 1e-8, 179.9);
  require_within("width [pixels]", static_cast<double>(camera.width), 1, 65535);
  require_within("height [pixels]", static_cast<double>(camera.height), 1, 65535);
  require_within("flattening", camera.flattening, 0.8, 1);
  if (camera.direction != glm::dvec3(0, 0, 0))
    require_within("length of the camera's direction", glm::length(camera.direction), 1e-100,
                   1e100);
  const glm::dvec3 sight = line_of_sight(camera);
  const double off_sight =
      std::atan2(glm::length(glm::cross(sight, camera.up)), std::abs(glm::dot(sight, camera.up)));
  require_within("angle between up and the line of sight [radians]", off_sight, 1e-6,
                 std::numbers::pi / 2);
}

Sight sight_of(const SceneCamera& camera) {
  const auto flattened = flattened_by_air(camera);
  const glm::dvec3 forward = line_of_sight(camera);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const double half_width = 0.5 * static_cast<double>(camera.width);
  const double pixel = std::tan(0.5 * in_radians(camera.horizontal_field)) / half_width;
  const glm::dvec3 across = pixel * right, down = -pixel * glm::cross(right, forward);
  return {camera.position,
          forward - half_width * across - 0.5 * static_cast<double>(camera.height) * down, across,
          down, glm::inverse(flattened)};
}

std::optional<glm::dvec3> ground_at(const Sight& sight, const glm::dvec2& pixel) {
  const glm::dvec3 ray =
      sight.round_from_flattened *
      glm::normalize(sight.corner + pixel.x * sight.across + pixel.y * sight.down);
  const glm::dvec3 from = sight.round_from_flattened * sight.position;
  // Distances start at the ray's point nearest to the Moon's centre, because those from a far camera lose digits.
  const double squared = glm::dot(ray, ray), away = -glm::dot(from, ray) / squared;
  const glm::dvec3 nearest = from + away * ray;
  const double inside = 1 - glm::dot(nearest, nearest);
  if (inside < 0 || away < 0) return std::nullopt;
  return nearest - std::sqrt(inside / squared) * ray;
}

}  // namespace coppermoon::povray_scenes
