// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "algebra/progress.h"
#include "almanac/sky.h"
#include "atmosphere/observer_air.h"
#include "colour/working_space.h"
#include "texture/image.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Request for an eclipse's shader.
struct ShaderRequest {
  LightRequest light{};
  colour::WorkingSpace space = colour::WorkingSpace::linear_rec709;
  std::optional<std::string> response{};  ///< as in colour::channel_weights
  /// Observer's air, whose reddening weighs the light; without: seen from space
  std::optional<atmosphere::Sightline> sightline{};
};

/// Light in the shadow of an eclipse as one small image, which shaders read:
///
///     columns   nodes of the axis distance in the middle plane, evenly spaced in each of four stretches
///     rows      plane by plane, the nearest first: position angles from celestial north through east, equally
///               spaced, the first once more at the end
///     texel     square roots of light over full sunlight, for ground of the Moon's mean colour
///
/// All planes hold light at a node's line from the limb (shadow::sheared).
struct LightStrip {
  texture::Image roots;                    ///< channels R, G, B
  std::array<double, 4> ends_km{};         ///< axis distances at which the stretches end
  std::array<int, 4> stretches{};          ///< numbers of nodes from one end to the next
  std::size_t sectors = 1;                 ///< position angles
  std::size_t planes = 2;                  ///< at equal distances; one for a moment
  double nearest_km = 0, farthest_km = 0;  ///< depths of the first plane and the last
  double error = 0;                        ///< found, of the brightest channel

  double middle_km() const { return (nearest_km + farthest_km) / 2; }
  double depth_km(std::size_t plane) const {
    return plane == 0 ? nearest_km
                      : std::lerp(nearest_km, farthest_km,
                                  static_cast<double>(plane) / static_cast<double>(planes - 1));
  }
};

/// Strip of the light of a request. It has 591 columns and 97 rows a plane. Where straight lines between texels err by more
/// than 0.6 % of the brightest channel, there are up to four times as many.
///
/// Given     sky        of the greatest eclipse, or of the moment: air, and the Sun's distance
///           nearest_km, farthest_km  depths of the first plane and the last [km]; equal: one plane
/// Accuracy  its `error` is told: the largest between all texels, and the largest of the light at some 1 700 places (750
///           with regions) against a finer quadrature. It bounds the error at 95 of 100 places between them, also where
///           it is above 1 %
/// Throws    Error      as refracted_light
LightStrip light_strip(const ShaderRequest& request, const almanac::SkyState& sky,
                       double nearest_km, double farthest_km,
                       const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
