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

struct ShaderRequest {
  LightRequest light{};
  colour::WorkingSpace space = colour::WorkingSpace::linear_rec709;
  std::optional<std::string> response{};  ///< camera response, as in colour::channel_weights
  /// Path through the observer's air, which reddens the light. If absent, the Moon is seen from space.
  std::optional<atmosphere::Sightline> sightline{};
};

/// Light in one or two planes across the Earth's shadow, stored as one small image that shaders read:
///
///     columns   distances from the shadow's axis halfway between the planes, evenly spaced in each of four stretches
///     rows      equally spaced position angles from celestial north through east, with the first angle repeated at
///               the end; all rows of the plane nearest to the Earth come first, then those of the other plane
///     texel     square roots of light relative to full sunlight, for ground of the Moon's mean colour
///
/// A column follows a line from the Earth's limb, so its axis distance differs between planes (shadow::sheared).
struct LightStrip {
  texture::Image roots;                    ///< square roots of light in R, G, B
  std::array<double, 4> ends_km{};         ///< axis distances at which stretches end
  std::array<int, 4> stretches{};          ///< number of columns in each stretch
  std::size_t sectors = 1;                 ///< number of position angles
  std::size_t planes = 2;                  ///< number of planes; 1 for a single moment
  double nearest_km = 0, farthest_km = 0;  ///< depths of the first and last plane
  double error = 0;                        ///< estimated error, relative to the brightest channel

  /// Axis distance at which a stretch begins.
  double from_km(std::size_t stretch) const { return stretch == 0 ? 0 : ends_km[stretch - 1]; }
  double middle_km() const { return (nearest_km + farthest_km) / 2; }
  double depth_km(std::size_t plane) const {
    return plane == 0 ? nearest_km
                      : std::lerp(nearest_km, farthest_km,
                                  static_cast<double>(plane) / static_cast<double>(planes - 1));
  }
};

/// Computes the light strip. It has 591 columns, and 97 rows per plane. If linear interpolation between its texels has
/// an error of more than 0.6 % of the brightest channel, it gets up to four times as many columns or rows.
///
/// Given     sky        at greatest eclipse or at the single moment; the air and the Sun's distance follow from it
///           nearest_km, farthest_km  depths of the first and last plane [km]; if equal, there is only one plane
/// Accuracy  estimated in `error`, as the largest interpolation error between texels plus the largest difference of
///           the light from a finer quadrature at some 1700 places (750 if parts of the Earth's limb have different
///           air). At 95 % of other places, the true error is smaller, even if `error` is above 1 %
/// Throws    Error      if refracted_light does
LightStrip light_strip(const ShaderRequest& request, const almanac::SkyState& sky,
                       double nearest_km, double farthest_km,
                       const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
