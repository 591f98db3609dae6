// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "uses/shader/light_strip.h"
#include "uses/shader/shadow_motion.h"

namespace coppermoon::uses {

/// Types of values, as MaterialX calls them.
inline constexpr const char *number_type = "float", *vector_type = "vector3",
                            *colour_type = "color3";

/// One step of a formula: a value, as a node of MaterialX computes it. Operations are "add", "subtract", "multiply", of
/// a vector also by a number, "divide", "min", "clamp" (to 0 to 1), "dotproduct", "normalize", "sqrt", "atan2" (of y and
/// x, −π to π), "floor", "mix" (of two values, by the share of the second), which every shading language has, and
///
///     "place"     input: point of the Moon in Moon-fixed axes, of any length
///     "time"      input: seconds from greatest eclipse
///     "constant"
///     "image"     texel of the strip at u and v, linearly interpolated; v from the image's top
struct Step {
  std::string operation, type;
  std::vector<std::size_t> operands{};  ///< earlier steps
  std::array<double, 3> constant{};     ///< of "constant"; a number stands first
  std::string name{}, meaning{};        ///< empty: a part of one expression
};

/// Steps, each after its operands; the last is the result.
using Formula = std::vector<Step>;

/// Light over full sunlight at a place of the Moon and a time, from which the shaders are written.
Formula shadow_formula(const ShadowMotion& motion, const LightStrip& strip);

}  // namespace coppermoon::uses
