// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "povray_scenes/render.h"
#include "povray_scenes/scene_camera.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// The Moon's edge in a frame: the ellipse xx dx² + xy dx dy + yy dy² = 1, with dx and dy measured from its middle
/// (x, y). Lengths are in pixels, with the origin in the frame's upper left corner and y downwards.
struct DiscOutline {
  double x, y, xx, xy, yy;
};

/// Outline of the Moon as a valid camera sees it; nothing if the Moon is behind it or too near for a closed outline.
std::optional<DiscOutline> disc_outline(const povray_scenes::SceneCamera& camera);

/// Share of a pixel that the Moon covers, 0 to 1. The Moon's edge is assumed to be straight within the pixel.
///
/// Given  x, y  middle of the pixel
double covered_share(const DiscOutline& outline, double x, double y);

/// Bounding rectangle of an outline, enlarged by one pixel on each side.
///
/// Given     width, height  of the frame
/// Returned  a rectangle of at least two columns and rows; nothing if the disc is outside the frame
std::optional<povray_scenes::RenderWindow> window_of(const DiscOutline& outline, std::size_t width,
                                                     std::size_t height);

/// Rectangle that bounds the Moon in the frames of all the cameras, enlarged by one pixel on each side.
///
/// Given     cameras  with frames of the same width and height
/// Returned  nothing if a camera has no disc_outline, or if no frame shows the Moon
std::optional<povray_scenes::RenderWindow> disc_window(
    std::span<const povray_scenes::SceneCamera> cameras);

/// Converts an outline to a string for a header, without loss of digits, and back. Other strings give nothing.
std::string text_of(const DiscOutline& outline);
std::optional<DiscOutline> outline_in(std::string_view text);

/// Pixels that the Moon's edge crosses. Their light is a mixture of Moon and sky, and clipping it would make the edge
/// jagged. They are therefore developed with the light of the ground beside them, then mixed with the developed sky.
class LimbPixels {
 public:
  /// Given  disc  if absent, there are no edge pixels
  ///        sky   whether the frame holds a sky, whose light is read beside the disc; otherwise the sky is black
  LimbPixels(const std::optional<DiscOutline>& disc, const texture::Image& frame, bool sky = false);

  /// The frame in which each edge pixel has the light of the ground beside it.
  texture::Image with_ground(texture::Image frame) const;

  /// The frame in which each edge pixel is a mixture of ground and sky, according to the share that the Moon covers.
  /// It is the inverse of with_ground.
  texture::Image covered(texture::Image frame) const;

  /// Mixes the sky into the edge pixels of a developed picture, by the share that the Moon does not cover.
  ///
  /// Given  pq  whether the picture is coded as PQ; otherwise it must be coded as sRGB (IEC 61966-2-1)
  void cover(texture::Image& picture, bool pq) const;

 private:
  using Place = std::pair<std::size_t, std::size_t>;  ///< row, column
  struct Pixel {
    std::size_t row, column;
    Place ground;
    std::optional<Place> sky;  ///< pixel that shows the sky; if absent, the sky is black
    double share;
  };

  std::vector<Pixel> pixels_;
};

}  // namespace coppermoon::uses
