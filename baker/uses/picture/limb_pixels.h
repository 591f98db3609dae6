// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "texture/image.h"
#include "uses/picture/disc_outline.h"

namespace coppermoon::uses {

/// Pixels that the Moon's edge crosses. A frame holds their mean light, and clipping it would show the edge as stairs.
/// So the light of the ground beside them is developed, and the developed colour is mixed with that of the sky.
class LimbPixels {
 public:
  /// Given  disc  without: none
  ///        sky   the frame holds a sky's light, which is found in pixels beside the disc; else it is black
  LimbPixels(const std::optional<DiscOutline>& disc, const texture::Image& frame, bool sky = false);

  /// Frame in which these pixels have the whole light of the ground beside them.
  texture::Image with_ground(texture::Image frame) const;

  /// Frame in which these pixels have the share of their light that the Moon covers, and the sky's for the rest:
  /// inverse of with_ground.
  texture::Image covered(texture::Image frame) const;

  /// Mixes these pixels of a developed picture with the sky by the share that the Moon does not cover.
  ///
  /// Given  pq  codes are PQ's; else they are taken for sRGB's (IEC 61966-2-1)
  void cover(texture::Image& picture, bool pq) const;

 private:
  using Place = std::pair<std::size_t, std::size_t>;  ///< row, column
  struct Pixel {
    std::size_t row, column;
    Place ground;
    std::optional<Place> sky;  ///< without: black
    double share;
  };

  std::vector<Pixel> pixels_;
};

}  // namespace coppermoon::uses
