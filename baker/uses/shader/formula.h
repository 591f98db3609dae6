// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "uses/shader/light_strip.h"
#include "uses/shader/shadow_motion.h"

namespace coppermoon::uses {

/// Names of the value types in MaterialX.
inline constexpr const char *number_type = "float", *vector_type = "vector3",
                            *colour_type = "color3";

/// One step of a formula. It computes one value, as a MaterialX node does. These operations exist in every shading
/// language: "add", "subtract", "multiply" (also a vector by a number), "divide", "min", "clamp" (to the range 0 to 1),
/// "dotproduct", "normalize", "sqrt", "atan2" (of y and x, −π to π), "floor", and "mix" (of two values, with the weight
/// of the second). The remaining operations are
///
///     "place"     input: vector of any length that points from the Moon's centre to the ground, in Moon-fixed axes
///     "time"      input: seconds from greatest eclipse
///     "constant"
///     "image"     the image of the shadow's light (LightStrip), interpolated linearly at u and v; v is 0 at the top
struct Step {
  std::string operation, type;
  std::vector<std::size_t> operands{};  ///< indices of earlier steps
  std::array<double, 3> constant{};     ///< for "constant"; a single number is in element 0
  std::string name{}, meaning{};        ///< a step without a name is part of another's expression
};

/// Steps in order of evaluation, each after its operands. The last step is the result.
using Formula = std::vector<Step>;

/// Formula for light on the Moon relative to full sunlight, by place and time. All shaders are generated from it.
Formula shadow_formula(const ShadowMotion& motion, const LightStrip& strip);

}  // namespace coppermoon::uses
