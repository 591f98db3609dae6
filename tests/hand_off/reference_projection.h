// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>

#include "povray_scenes/scene_camera.h"
#include "texture/image.h"

namespace coppermoon::hand_off {

using Rgb = glm::dvec3;

/// Between the four texels around a place; plate carrée, longitude 0 in the middle, north up.
inline Rgb texel_at(const texture::Image& map, const glm::dvec3& on_sphere) {
  const auto columns = static_cast<double>(map.width), rows = static_cast<double>(map.height);
  const double turns = std::atan2(on_sphere.y, on_sphere.x) / (2 * std::numbers::pi);
  const double x = (turns + 0.5) * columns - 0.5;
  const double y = std::clamp(
      (0.5 - std::asin(std::clamp(on_sphere.z, -1., 1.)) / std::numbers::pi) * rows - 0.5, 0.,
      rows - 1);
  Rgb sum{0, 0, 0};
  for (const double row : {std::floor(y), std::floor(y) + 1})
    for (const double column : {std::floor(x), std::floor(x) + 1}) {
      const double weight = (1 - std::abs(y - row)) * (1 - std::abs(x - column));
      const auto r = static_cast<std::size_t>(std::min(row, rows - 1));
      const auto c = static_cast<std::size_t>(column + columns) % map.width;
      sum += weight * Rgb(map(r, c, 0), map(r, c, 1), map(r, c, 2));
    }
  return sum;
}

/// Where a ray meets the unit sphere first, by the quadratic equation.
inline std::optional<glm::dvec3> met(const glm::dvec3& from, const glm::dvec3& ray) {
  const double a = glm::dot(ray, ray), b = glm::dot(from, ray), c = glm::dot(from, from) - 1;
  const double discriminant = b * b - a * c;
  if (discriminant < 0) return std::nullopt;
  return from + (-b - std::sqrt(discriminant)) / a * ray;
}

/// The frame of a Moon that shines by its texture, by rays and nothing else: each pixel is the mean
/// of so many rays a side, on a regular grid.
///
/// Given  camera  towards the Moon's centre, neither mirrored nor flattened
inline texture::Image reference_projection(const texture::Image& map,
                                           const povray_scenes::SceneCamera& camera, int rays = 8) {
  const glm::dvec3 forward = -glm::normalize(camera.position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
  const glm::dvec3 down = glm::cross(forward, right);
  const auto width = static_cast<double>(camera.width), height = static_cast<double>(camera.height);
  const double pixel = 2 * std::tan(in_radians(camera.horizontal_field) / 2) / width;
  texture::Image frame(camera.width, camera.height, {"R", "G", "B"});
  for (std::size_t r = 0; r < camera.height; ++r)
    for (std::size_t c = 0; c < camera.width; ++c) {
      Rgb sum{0, 0, 0};
      for (int i = 0; i < rays * rays; ++i) {
        const double x = static_cast<double>(c) + (i % rays + 0.5) / rays - width / 2;
        const double y = static_cast<double>(r) + (i / rays + 0.5) / rays - height / 2;
        const auto place = met(camera.position, forward + pixel * (x * right + y * down));
        if (place) sum += texel_at(map, *place);
      }
      for (int k = 0; k < 3; ++k)
        frame(r, c, static_cast<std::size_t>(k)) = static_cast<float>(sum[k] / (rays * rays));
    }
  return frame;
}

}  // namespace coppermoon::hand_off
