// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "povray_scenes/camera.h"

namespace coppermoon::uses {

/// The Moon's edge in a frame, an ellipse: xx dx² + xy dx dy + yy dy² = 1 about its middle, in pixels from
/// the upper left corner, y down.
struct DiscOutline {
  double x, y, xx, xy, yy;
};

/// Given     camera  sound
/// Returned  nothing where the Moon has no closed edge before the camera: it stands behind, or too near
std::optional<DiscOutline> disc_outline(const povray_scenes::Camera& camera);

/// Share of the pixel that the Moon covers, 0 to 1, its edge taken as straight there.
///
/// Given  x, y  of the pixel's middle
double covered_share(const DiscOutline& outline, double x, double y);

/// The outline as a header's text holds it, to the last digit, and back; nothing where a text holds none.
std::string text_of(const DiscOutline& outline);
std::optional<DiscOutline> outline_in(std::string_view text);

}  // namespace coppermoon::uses
