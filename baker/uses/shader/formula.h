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

/// One step of a formula: a value, computed as a MaterialX node would. Every shading language has the operations "add",
/// "subtract", "multiply" (also a vector by a number), "divide", "min", "clamp" (to 0 to 1), "dotproduct", "normalize",
/// "sqrt", "atan2" (of y and x, −π to π), "floor" and "mix" (of two values, by the share of the second). The others are
///
///     "place"     input: vector to a point on the Moon in Moon-fixed axes, of any length
///     "time"      input: seconds from greatest eclipse
///     "constant"
///     "image"     the strip at u and v, linearly interpolated; v is measured from the image's top
struct Step {
  std::string operation, type;
  std::vector<std::size_t> operands{};  ///< earlier steps
  std::array<double, 3> constant{};     ///< for "constant"; a number comes first
  std::string name{}, meaning{};        ///< if empty, part of a larger expression
};

/// Steps, each after its operands; the last is the result.
using Formula = std::vector<Step>;

/// Formula for the ratio of light to full sunlight at a place on the Moon and a time. All shaders are written from it.
Formula shadow_formula(const ShadowMotion& motion, const LightStrip& strip);

}  // namespace coppermoon::uses
