// SPDX-License-Identifier: MIT
#include "uses/compare/frame_places.h"

#include <glm/geometric.hpp>

namespace coppermoon::uses {

FramePlaces frame_places(const almanac::SkyState& sky, const povray_scenes::SceneCamera& camera) {
  return {sky, eclipse::shadow_axis(sky), camera, povray_scenes::sight_of(camera)};
}

std::optional<double> axis_distance_km(const FramePlaces& places, const glm::dvec2& pixel) {
  constexpr double least_emission_cosine = 0.25;  // 0.97 of the disc's radius
  const auto ground = povray_scenes::ground_at(places.sight, pixel);
  if (!ground ||
      glm::dot(*ground, glm::normalize(places.sight.position - *ground)) < least_emission_cosine)
    return std::nullopt;
  return algebra::in_kilometres(
      eclipse::place_of_ground(places.axis, places.sky, *ground).axis_distance);
}

}  // namespace coppermoon::uses
