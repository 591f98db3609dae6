// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "povray_scenes/camera.h"

namespace coppermoon::uses {

/// Geometry of a frame: its camera, the sky of its moment, the Earth's shadow.
struct FramePlaces {
  almanac::SkyState sky;
  eclipse::ShadowAxis axis;
  povray_scenes::SceneCamera camera;
  povray_scenes::Sight sight;
};

/// Geometry of a frame rendered by a camera.
///
/// Throws  Error  when the camera is not sound
FramePlaces frame_places(const almanac::SkyState& sky, const povray_scenes::SceneCamera& camera);

/// Distance from the shadow's axis of the ground that a place of the frame shows [km]; nothing beside the Moon and
/// beyond 0.97 of its radius.
std::optional<double> axis_distance_km(const FramePlaces& places, const glm::dvec2& pixel);

}  // namespace coppermoon::uses
