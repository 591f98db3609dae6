// SPDX-License-Identifier: MIT
#include "uses/picture/frame_sky.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "povray_scenes/scene_camera.h"
#include "uses/light/spectral_bands.h"
#include "uses/picture/brightness.h"
#include "uses/picture/camera_request.h"

namespace coppermoon::uses {
namespace {

/// Spacing of the nodes at which the sky is computed [pixels]: a quarter of a degree, limited to 4 to 64 pixels.
std::size_t step_of(const povray_scenes::SceneCamera& camera) {
  const double quarter = std::numbers::pi / 720 / pixel_rad_of(camera);
  return static_cast<std::size_t>(std::clamp(quarter, 4., 64.));
}

/// Raises a direction to the horizon if it is below the horizon.
glm::dvec3 not_below(const glm::dvec3& direction) {
  const glm::dvec3 level{direction.x, direction.y, 0};
  return direction.z < 0 && glm::length(level) > 0 ? glm::normalize(level) : direction;
}

}  // namespace

FrameSky::FrameSky(const View& view, const LitMoon& moon) : camera_(view.camera) {
  if (view.sky_cd_m2 || !view.observer) {
    at_moon_cd_m2_ = view.sky_cd_m2.value_or(0);
    return;
  }
  axes_ = axes_as_seen(view, moon.sky);
  clear_.emplace(*view.observer, moon.sky, view.air, magnitudes_above(moon));
  const auto place = apparent_place(*view.observer, moon.sky);
  at_moon_cd_m2_ = colour::luminance(
      picture_space, clear_->light(not_below(in_sky(place.altitude, place.azimuth))));
}

FrameSky::Nodes FrameSky::nodes() const {
  const auto step = step_of(camera_), columns = (camera_.width + step - 1) / step + 1,
             rows = (camera_.height + step - 1) / step + 1;
  Nodes nodes{step, {columns, rows, {"R", "G", "B"}}};
  const auto even = static_cast<float>(at_moon_cd_m2_);
  if (!clear_) {
    std::ranges::fill(nodes.light.values, even);
    return nodes;
  }
  const auto sight = povray_scenes::sight_of(camera_);
  const auto to_sky = glm::transpose(axes_);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const auto ray = sight.corner + static_cast<double>(column * step) * sight.across +
                       static_cast<double>(row * step) * sight.down;
      const auto light = clear_->light(not_below(to_sky * glm::normalize(ray)));
      for (std::size_t k = 0; k < light.size(); ++k)
        nodes.light(row, column, k) = static_cast<float>(light[k]);
    }
  });
  return nodes;
}

void FrameSky::add_to(texture::Image& frame) const {
  if (black()) return;
  const auto sky = nodes();
  const auto& light = sky.light;
  const auto place = [&](std::size_t pixel) {
    const double at = (static_cast<double>(pixel) + 0.5) / static_cast<double>(sky.step);
    const auto first = static_cast<std::size_t>(at);
    return std::pair(first, static_cast<float>(at - static_cast<double>(first)));
  };
  tbb::parallel_for(std::size_t{0}, frame.height, [&](std::size_t row) {
    const auto [r, down] = place(row);
    for (std::size_t column = 0; column < frame.width; ++column) {
      const auto [c, across] = place(column);
      for (std::size_t k = 0; k < 3; ++k)
        frame(row, column, k) +=
            (1 - down) * ((1 - across) * light(r, c, k) + across * light(r, c + 1, k)) +
            down * ((1 - across) * light(r + 1, c, k) + across * light(r + 1, c + 1, k));
    }
  });
}

}  // namespace coppermoon::uses
