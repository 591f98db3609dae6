// SPDX-License-Identifier: MIT
#include "povray_scenes/sight.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace coppermoon::povray_scenes {

Sight sight_of(const SceneCamera& camera) {
  require_sound(camera);
  const glm::dvec3 forward = line_of_sight(camera);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const double half_width = 0.5 * static_cast<double>(camera.width);
  const double pixel = std::tan(0.5 * in_radians(camera.horizontal_field)) / half_width;
  const glm::dvec3 across = (camera.mirrored ? -pixel : pixel) * right,
                   down = -pixel * glm::cross(right, forward);
  return {camera.position,
          forward - half_width * across - 0.5 * static_cast<double>(camera.height) * down, across,
          down, glm::inverse(flattened_by_air(camera))};
}

std::optional<glm::dvec3> ground_at(const Sight& sight, const glm::dvec2& pixel) {
  const glm::dvec3 ray =
      sight.round_from_flattened *
      glm::normalize(sight.corner + pixel.x * sight.across + pixel.y * sight.down);
  const glm::dvec3 from = sight.round_from_flattened * sight.position;
  // First the nearest place along the ray: seen from afar, the distance of the ground is a
  // difference of large numbers.
  const double squared = glm::dot(ray, ray), away = -glm::dot(from, ray) / squared;
  const glm::dvec3 nearest = from + away * ray;
  const double inside = 1 - glm::dot(nearest, nearest);
  if (inside < 0 || away < 0) return std::nullopt;
  return nearest - std::sqrt(inside / squared) * ray;
}

}  // namespace coppermoon::povray_scenes
