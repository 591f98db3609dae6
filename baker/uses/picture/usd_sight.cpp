// SPDX-License-Identifier: MIT
#include "uses/picture/usd_sight.h"

#include <glm/geometric.hpp>

namespace coppermoon::uses {

texture::UsdMoment usd_moment(const LitMoon& moon, const View& view, colour::WorkingSpace space) {
  const auto direction = line_of_sight(view.camera);
  const auto up = view.camera.up - glm::dot(view.camera.up, direction) * direction;
  return {.position = view.camera.position,
          .direction = direction,
          .up = glm::normalize(up),
          .field_rad = algebra::in_radians(view.camera.horizontal_field),
          .lux = illuminance_seen(moon, space)};
}

std::array<double, 3> luminance_of_channels(colour::WorkingSpace space) {
  const auto of = [&](std::array<double, 3> colour) { return colour::luminance(space, colour); };
  return {of({1, 0, 0}), of({0, 1, 0}), of({0, 0, 1})};
}

}  // namespace coppermoon::uses
