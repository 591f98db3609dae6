// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>

#include "algebra/progress.h"
#include "almanac/sky.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Light in the shadow of a whole eclipse as one small image, which shaders read:
///
///     columns   nodes of the axis distance in the middle plane, evenly spaced in each of three stretches
///     rows      for the nearer plane, then for the farther one: position angles from celestial north through east,
///               equally spaced, the first once more at the end
///     texel     square roots of light over full sunlight, for ground of the Moon's mean colour
///
/// Both planes hold light at a node's line from the limb (shadow::sheared).
struct LightStrip {
  texture::Image roots;                  ///< channels R, G, B
  std::array<double, 3> ends_km{};       ///< axis distances at which the stretches end
  std::array<int, 3> stretches{};        ///< numbers of nodes from one end to the next
  std::size_t sectors = 1;               ///< position angles
  double nearer_km = 0, farther_km = 0;  ///< depths of the planes

  double middle_km() const { return (nearer_km + farther_km) / 2; }
};

/// Strip of the light of a request.
///
/// Given     sky        of the greatest eclipse: air, and the Sun's distance
///           nearer_km, farther_km  depths of the planes [km]
///           response   as in colour::channel_weights
/// Accuracy  0.5 % of the brightest channel, beside that of the light
/// Throws    Error      as refracted_light
LightStrip light_strip(const LightRequest& request, const almanac::SkyState& sky, double nearer_km,
                       double farther_km, colour::WorkingSpace space,
                       const std::optional<std::string>& response,
                       const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
