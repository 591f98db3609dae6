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

/// Light of the sky in a frame. It comes from air in front of the camera, so it covers the Moon as much as its
/// surroundings.
///
/// Over a place it is ClearSky's, evaluated at nodes and linear between them. If a luminance is asked for, the sky is
/// even, white as D65; otherwise, from space, it is black. Below the horizon the sky continues as on the horizon.
///
/// Accuracy  of interpolation 1e-3 from 5 degrees up, 1 % just above the horizon
/// Omits     the response that the Moon and the stars are seen through, if any
class FrameSky {
 public:
  /// Given   moon  lights the air; its albedo may have any size
  /// Throws  Error  as ClearSky
  FrameSky(const View& view, const LitMoon& moon);

  bool black() const { return at_moon_cd_m2_ == 0; }
  /// Luminance towards the Moon's middle; 0 for a black sky.
  double at_moon_cd_m2() const { return at_moon_cd_m2_; }

  /// Adds the sky's light to the channels R, G, B of a frame from the view's camera [cd/m²].
  void add_to(texture::Image& frame) const;

  /// Light at every `step` pixels from the frame's upper left corner to beyond its right and lower sides: R, G, B,
  /// linear Rec.709 [cd/m²]
  struct Nodes {
    std::size_t step;
    texture::Image light;
  };
  Nodes nodes() const;

 private:
  povray_scenes::SceneCamera camera_;
  glm::dmat3 axes_{1};  ///< from axes_as_seen
  std::optional<ClearSky> clear_;
  double at_moon_cd_m2_ = 0;
};

}  // namespace coppermoon::uses
