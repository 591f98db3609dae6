// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <optional>

#include "povray_scenes/camera.h"
#include "texture/image.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Light of the sky in a frame: of air between the camera and space, so before the Moon as much as beside it.
///
/// Over a place it is ClearSky's, evaluated at nodes and linear between them; of a luminance that is asked for it is even,
/// white as D65. From space it is black unless one is asked for. Below the horizon it is that of the horizon.
///
/// Accuracy  of interpolation 1e-3 from 5 degrees up, 1 % above the horizon
/// Omits     the response that the Moon and the stars are seen through, if any
class FrameSky {
 public:
  /// Given   moon  lights the air; of any size of its albedo
  /// Throws  Error  as ClearSky
  FrameSky(const View& view, const LitMoon& moon);

  bool black() const { return at_moon_cd_m2_ == 0; }
  /// Luminance towards the Moon's middle; 0: black
  double at_moon_cd_m2() const { return at_moon_cd_m2_; }

  /// Adds it to the channels R, G, B of a frame of the view's camera [cd/m²].
  void add_to(texture::Image& frame) const;

  /// Light at every `step` pixels from the frame's upper left corner on, beyond its other sides: R, G, B, linear
  /// Rec.709 [cd/m²]
  struct Nodes {
    std::size_t step;
    texture::Image light;
  };
  Nodes nodes() const;

 private:
  povray_scenes::SceneCamera camera_;
  glm::dmat3 axes_{1};  ///< of axes_as_seen
  std::optional<ClearSky> clear_;
  double at_moon_cd_m2_ = 0;
};

}  // namespace coppermoon::uses
