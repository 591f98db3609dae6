// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "uses/shader/light_strip.h"
#include "uses/shader/shadow_motion.h"

namespace coppermoon::uses {

/// Kind of a step's value.
enum class ValueKind { number, vector, colour };

/// Operations that every shading language has. Binary ones take equal kinds, but for `multiply`, whose second operand
/// may be a number beside a vector or a colour, and `mix`, whose third is a number.
enum class Operation {
  place,  ///< input: point of the Moon in Moon-fixed axes, of any length
  time,   ///< input: seconds from greatest eclipse
  constant,
  add,
  subtract,
  multiply,
  divide,
  minimum,
  clamp,  ///< to 0 to 1
  dot,
  normalize,
  square_root,
  arc_tangent,  ///< of y and x, −π to π
  floor,
  mix,    ///< of two values, by the share of the second
  texel,  ///< of the strip at u and v, linearly interpolated; v from the image's top
};

/// One step of a formula.
struct Step {
  Operation operation;
  ValueKind kind;
  std::vector<std::size_t> operands{};  ///< earlier steps
  std::array<double, 3> constant{};     ///< of `constant`; a number stands first
  std::string name{}, meaning{};        ///< empty: a part of one expression
};

/// Steps, each after its operands; the last is the result.
using Formula = std::vector<Step>;

/// Light over full sunlight at a place of the Moon and a time, from which the shaders are written.
Formula shadow_formula(const ShadowMotion& motion, const LightStrip& strip);

}  // namespace coppermoon::uses
