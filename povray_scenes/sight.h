// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "povray_scenes/camera.h"

namespace coppermoon::povray_scenes {

/// Lines of sight of a camera, Moon-fixed, in lunar radii: corner + x across + y down.
struct Sight {
  glm::dvec3 position, corner, across, down;
  glm::dmat3 round_from_flattened;  ///< inverse of flattened_by_air
};

/// Throws  Error  when the camera is not sound
Sight sight_of(const SceneCamera& camera);

/// Place on the Moon that a pixel shows: inverse of pixel_of.
///
/// Given     pixel  from the upper left corner, y down, the first pixel's centre at (0.5, 0.5)
/// Returned  unit vector, Moon-fixed; nothing beside the Moon
std::optional<glm::dvec3> ground_at(const Sight& sight, const glm::dvec2& pixel);

}  // namespace coppermoon::povray_scenes
