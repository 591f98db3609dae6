// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace coppermoon::colour {

/// sRGB code for linear light, both 0 to 1.
///
/// Source  IEC 61966-2-1
inline double srgb_code(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

/// Linear light for an sRGB code; the inverse of srgb_code.
inline double srgb_light(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

}  // namespace coppermoon::colour
