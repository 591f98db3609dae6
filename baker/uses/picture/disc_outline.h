// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "povray_scenes/camera.h"
#include "povray_scenes/render.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// Ellipse of the Moon's edge in a frame: xx dx² + xy dx dy + yy dy² = 1 about its middle, in pixels from the upper
/// left corner, y down.
struct DiscOutline {
  double x, y, xx, xy, yy;
};

/// Outline of the Moon before a sound camera; nothing where its edge is not closed: behind the camera, or too near.
std::optional<DiscOutline> disc_outline(const povray_scenes::SceneCamera& camera);

/// Share of a pixel that the Moon covers, 0 to 1, its edge taken as straight within the pixel.
///
/// Given  x, y  of the pixel's middle
double covered_share(const DiscOutline& outline, double x, double y);

/// Bounding rectangle of an outline, one pixel wider on each side.
///
/// Given     width, height  of the frame
/// Returned  two columns and rows or more; nothing where the disc is beside the frame
std::optional<povray_scenes::RenderWindow> window_of(const DiscOutline& outline, std::size_t width,
                                                     std::size_t height);

/// Bounding rectangle of the Moon over the frames of several cameras.
///
/// Given     cameras  of one width and height
/// Returned  one pixel wider on each side; nothing where the edge is not closed in one of them, or the Moon is in none
std::optional<povray_scenes::RenderWindow> disc_window(
    std::span<const povray_scenes::SceneCamera> cameras);

/// Outline as text for a header, to the last digit, and back; nothing for another text.
std::string text_of(const DiscOutline& outline);
std::optional<DiscOutline> outline_in(std::string_view text);

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
