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
  /// Observer's air, whose reddening weights the light; if absent, the Moon is seen from space
  std::optional<atmosphere::Sightline> sightline{};
};

/// Light in an eclipse's shadow as one small image for shaders:
///
///     columns   nodes of the axis distance in the middle plane, evenly spaced in each of four stretches
///     rows      plane by plane, the nearest first: equally spaced position angles from celestial north through
///               east, with the first repeated at the end
///     texel     square roots of the ratio of light to full sunlight, for ground of the Moon's mean colour
///
/// In every plane, a node's light is at the point where a line from the limb crosses that plane (shadow::sheared).
struct LightStrip {
  texture::Image roots;                    ///< channels R, G, B
  std::array<double, 4> ends_km{};         ///< axis distances at which the stretches end
  std::array<int, 4> stretches{};          ///< numbers of nodes from one end to the next
  std::size_t sectors = 1;                 ///< number of position angles
  std::size_t planes = 2;                  ///< evenly spaced; one for a single moment
  double nearest_km = 0, farthest_km = 0;  ///< depths of the first and last plane
  double error = 0;                        ///< as measured, relative to the brightest channel

  /// Axis distance at which a stretch begins.
  double from_km(std::size_t stretch) const { return stretch == 0 ? 0 : ends_km[stretch - 1]; }
  double middle_km() const { return (nearest_km + farthest_km) / 2; }
  double depth_km(std::size_t plane) const {
    return plane == 0 ? nearest_km
                      : std::lerp(nearest_km, farthest_km,
                                  static_cast<double>(plane) / static_cast<double>(planes - 1));
  }
};

/// Strip for the requested light. It has 591 columns, and 97 rows per plane. Where linear interpolation between texels
/// errs by more than 0.6 % of the brightest channel, there are up to four times as many.
///
/// Given     sky        at greatest eclipse or at the moment; gives the air and the Sun's distance
///           nearest_km, farthest_km  depths of the first and last plane [km]; one plane if they are equal
/// Accuracy  reported as `error`: the largest error between all texels, plus the light's largest error at some 1700
///           places (750 with regions) compared with a finer quadrature. It bounds the error at 95 of 100 places in
///           between, even where it is above 1 %
/// Throws    Error      as refracted_light
LightStrip light_strip(const ShaderRequest& request, const almanac::SkyState& sky,
                       double nearest_km, double farthest_km,
                       const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
