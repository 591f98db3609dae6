// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "povray_scenes/sight.h"

namespace coppermoon::uses {

/// Places in the Earth's shadow of the ground that a frame shows.
struct FramePlaces {
  almanac::SkyState sky;
  eclipse::ShadowAxis axis;
  povray_scenes::Camera camera;
  povray_scenes::Sight sight;
};

/// Places of a frame, by the sky of its moment and the camera that it was rendered with.
///
/// Throws  Error  when the camera is not sound
FramePlaces frame_places(const almanac::SkyState& sky, const povray_scenes::Camera& camera);

/// Distance from the shadow's axis of what a place of the frame shows [km]; nothing beside the Moon,
/// nor within a thirtieth of its radius of the limb.
std::optional<double> axis_distance_km(const FramePlaces& places, const glm::dvec2& pixel);

}  // namespace coppermoon::uses
