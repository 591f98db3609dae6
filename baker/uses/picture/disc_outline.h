// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "povray_scenes/camera.h"
#include "povray_scenes/render.h"

namespace coppermoon::uses {

/// The Moon's edge in a frame, an ellipse: xx dx² + xy dx dy + yy dy² = 1 about its middle, in pixels from
/// the upper left corner, y down.
struct DiscOutline {
  double x, y, xx, xy, yy;
};

/// Given     camera  sound
/// Returned  nothing where the Moon has no closed edge before the camera: it stands behind, or too near
std::optional<DiscOutline> disc_outline(const povray_scenes::SceneCamera& camera);

/// Share of the pixel that the Moon covers, 0 to 1, its edge taken as straight there.
///
/// Given  x, y  of the pixel's middle
double covered_share(const DiscOutline& outline, double x, double y);

/// The pixels that an outline goes about, and one more on each side.
///
/// Given     width, height  of the frame
/// Returned  two columns and rows or more; nothing where the disc is beside the frame
std::optional<povray_scenes::RenderWindow> window_of(const DiscOutline& outline, std::size_t width,
                                                     std::size_t height);

/// The part of their picture that the Moon takes in any of some cameras' frames.
///
/// Given     cameras  of one width and height
/// Returned  a pixel more on each side; nothing where the Moon has no closed edge in one of them, or is
///           in none of them
std::optional<povray_scenes::RenderWindow> disc_window(
    std::span<const povray_scenes::SceneCamera> cameras);

/// The outline as a header's text holds it, to the last digit, and back; nothing where a text holds none.
std::string text_of(const DiscOutline& outline);
std::optional<DiscOutline> outline_in(std::string_view text);

}  // namespace coppermoon::uses
