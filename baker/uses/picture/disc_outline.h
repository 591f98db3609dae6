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

/// The Moon's edge in a frame, as an ellipse: xx dx² + xy dx dy + yy dy² = 1 about its middle (x, y), in pixels from
/// the upper left corner, y down.
struct DiscOutline {
  double x, y, xx, xy, yy;
};

/// Outline of the Moon in front of a valid camera; nothing if its edge is not closed: behind the camera, or too near.
std::optional<DiscOutline> disc_outline(const povray_scenes::SceneCamera& camera);

/// Share of a pixel that the Moon covers, 0 to 1; the edge is taken as straight within the pixel.
///
/// Given  x, y  middle of the pixel
double covered_share(const DiscOutline& outline, double x, double y);

/// Bounding rectangle of an outline, one pixel wider on each side.
///
/// Given     width, height  of the frame
/// Returned  at least two columns and rows; nothing if the disc is outside the frame
std::optional<povray_scenes::RenderWindow> window_of(const DiscOutline& outline, std::size_t width,
                                                     std::size_t height);

/// Rectangle that bounds the Moon in the frames of all the cameras.
///
/// Given     cameras  with frames of the same width and height
/// Returned  one pixel wider on each side; nothing if the edge is not closed in one frame, or the Moon is in none
std::optional<povray_scenes::RenderWindow> disc_window(
    std::span<const povray_scenes::SceneCamera> cameras);

/// Converts an outline to text for a header, to the last digit, and back; nothing for any other text.
std::string text_of(const DiscOutline& outline);
std::optional<DiscOutline> outline_in(std::string_view text);

/// Pixels that the Moon's edge crosses. A frame holds their mean light, and clipping it would make the edge jagged.
/// So the light of the ground beside them is developed, and the developed colour is mixed with the sky's.
class LimbPixels {
 public:
  /// Given  disc  if absent, there are no such pixels
  ///        sky   the frame holds the light of a sky, which is found in pixels beside the disc; else the sky is black
  LimbPixels(const std::optional<DiscOutline>& disc, const texture::Image& frame, bool sky = false);

  /// The frame with these pixels given the full light of the ground beside them.
  texture::Image with_ground(texture::Image frame) const;

  /// The frame with these pixels reduced to the share that the Moon covers, with the sky's light for the rest:
  /// the inverse of with_ground.
  texture::Image covered(texture::Image frame) const;

  /// Mixes the sky into these pixels of a developed picture, by the share that the Moon does not cover.
  ///
  /// Given  pq  the picture is coded as PQ; otherwise it is taken as sRGB (IEC 61966-2-1)
  void cover(texture::Image& picture, bool pq) const;

 private:
  using Place = std::pair<std::size_t, std::size_t>;  ///< row, column
  struct Pixel {
    std::size_t row, column;
    Place ground;
    std::optional<Place> sky;  ///< if absent, black
    double share;
  };

  std::vector<Pixel> pixels_;
};

}  // namespace coppermoon::uses
