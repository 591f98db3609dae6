// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <optional>

#include "povray_scenes/scene_camera.h"
#include "texture/image.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Light of the sky in a frame. It comes from air in front of the Moon, so it is added to the Moon as well as to its
/// surroundings.
///
/// If a luminance is requested, the sky is uniform and has the colour of D65. Otherwise, the sky over an observer is a
/// ClearSky, interpolated between nodes. Below the horizon, it has the horizon's light. From space, the sky is black.
///
/// Accuracy  relative errors of the interpolation are 0.1 % above 5 degrees of altitude, and 1 % near the horizon
/// Omits     the effect of a spectral response on the sky's colour
class FrameSky {
 public:
  /// Given   moon  the Moon, which lights the air; its albedo map may have any size
  /// Throws  Error  when ClearSky does
  FrameSky(const View& view, const LitMoon& moon);

  bool black() const { return at_moon_cd_m2_ == 0; }
  /// Luminance towards the Moon's middle; 0 for a black sky.
  double at_moon_cd_m2() const { return at_moon_cd_m2_; }

  /// Adds the sky's light to the channels R, G, B of a frame from the view's camera [cd/m²].
  void add_to(texture::Image& frame) const;

  /// Light of the sky at nodes that are `step` pixels apart, from the frame's upper left corner to beyond its right
  /// and lower edges: R, G, B, linear Rec.709 [cd/m²].
  struct Nodes {
    std::size_t step;
    texture::Image light;
  };
  Nodes nodes() const;

 private:
  povray_scenes::SceneCamera camera_;
  glm::dmat3 axes_{1};  ///< axes of the sky, from axes_as_seen
  std::optional<ClearSky> clear_;
  double at_moon_cd_m2_ = 0;
};

}  // namespace coppermoon::uses
