// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "colour/display.h"

namespace coppermoon::colour {

/// Colour in CIE 1976 L*a*b*, relative to D65.
struct Lab {
  double L;     ///< lightness: 0 black, 100 white
  double a, b;  ///< redness and yellowness; both are 0 for greys
};

/// Converts XYZ to L*a*b*.
///
///     L* = 116 f(Y) − 16,  a* = 500 (f(X/Xw) − f(Y)),  b* = 200 (f(Y) − f(Z/Zw))
///     f(t) = t^(1/3) above (6/29)³, else t/(3 (6/29)²) + 4/29
///
/// Given   xyz  divided by the luminance of white (D65), so that white has Y = 1
/// Source  CIE 15:2004 §8.2.1
Lab lab_from_xyz(const glm::dvec3& xyz);

/// L*a*b* of a pixel in a developed picture.
///
/// Given   coded  sRGB-coded channels, 0 to 1
/// Throws  Error  when a channel is outside its range
/// Source  IEC 61966-2-1
Lab lab_from_srgb(const Rgb& coded);

/// Colour difference CIEDE2000 with k_L = k_C = k_H = 1.
///
///     ΔE = √(l² + c² + h² + R_T c h),   l = ΔL'/S_L, c = ΔC'/S_C, h = ΔH'/S_H
///
/// Returned  0 for equal colours; about 1 if the difference is just noticeable side by side. Symmetric in its arguments
/// Accuracy  1e-4 against 34 published colour differences, which are printed to that precision
/// Omits     effects of dark adaptation, neighbouring colours and size; the formula holds for samples in a lit room
/// Source    Sharma, Wu & Dalal (2005), Color Res. Appl. 30, 21
double delta_e_2000(const Lab& one, const Lab& other);

}  // namespace coppermoon::colour
