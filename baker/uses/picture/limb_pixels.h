// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "texture/image.h"
#include "uses/picture/disc_outline.h"

namespace coppermoon::uses {

/// Pixels that the Moon's edge crosses. A frame has the mean of their light; where that is clipped, the edge
/// would show as stairs. So the light of the ground beside them is developed, and the mean is taken of what
/// the display shows of it and of the black sky.
class LimbPixels {
 public:
  /// Given  disc  without: none
  LimbPixels(const std::optional<DiscOutline>& disc, const texture::Image& frame);

  /// The frame, these pixels with the whole light of the ground beside them.
  texture::Image with_ground(texture::Image frame) const;

  /// The frame, these pixels with as much of their light as the Moon covers of them: with_ground, backwards.
  texture::Image covered(texture::Image frame) const;

  /// Has the Moon cover these pixels of the developed picture as far as it does.
  ///
  /// Given  pq  codes are PQ's; else they are taken for sRGB's (IEC 61966-2-1)
  void cover(texture::Image& picture, bool pq) const;

 private:
  using Place = std::pair<std::size_t, std::size_t>;  ///< row, column
  struct Pixel {
    std::size_t row, column;
    Place ground;
    double share;
  };

  static std::optional<Place> beside(const DiscOutline& disc, const texture::Image& frame,
                                     std::size_t row, std::size_t column);

  std::vector<Pixel> pixels_;
};

}  // namespace coppermoon::uses
