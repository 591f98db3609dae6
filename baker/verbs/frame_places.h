// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>
#include <optional>

#include "almanac/sky.h"
#include "eclipse/shadow_axis.h"
#include "povray_scenes/sight.h"

namespace coppermoon::verbs {

/// Where the ground that a frame shows stands in the Earth's shadow.
struct FramePlaces {
  almanac::SkyState sky;
  eclipse::ShadowAxis axis;
  povray_scenes::Camera camera;
  povray_scenes::Sight sight;
};

/// Reads a still's recipe.
///
/// Given   told_by  a file that coppermoon made, the frame itself or its scene's texture
/// Throws  Error    when it has no recipe, or one without an instant, as a film's
FramePlaces frame_places(const std::filesystem::path& told_by);

/// Distance from the shadow's axis of what a place of the frame shows [km]; nothing beside the Moon,
/// nor within a thirtieth of its radius of the limb.
std::optional<double> axis_distance_km(const FramePlaces& places, const glm::dvec2& pixel);

}  // namespace coppermoon::verbs
