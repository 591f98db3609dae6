// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

/// Words of a language whose expressions are like C's.
struct Language {
  std::string vector, colour, literal;  ///< types, and a vector's constructor
  std::string time;                     ///< name of the input; OSL has a `time` of its own
  std::string arc_tangent;
  std::string texel;  ///< of {0}, {1}
};

const Language glsl{"vec3", "vec3", "vec3",
                    "time", "atan", "texture(eclipse_strip, vec2({}, {})).rgb"};
const Language osl{"vector",
                   "color",
                   "vector",
                   "seconds",
                   "atan2",
                   "(color)texture(strip, {}, {}, \"width\", 0, \"blur\", 0, \"wrap\", \"clamp\", "
                   "\"interp\", \"linear\")"};

std::string literal(double number) {
  auto text = fmt::format("{:.9g}", number);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

/// Writer of a formula's steps as expressions.
struct ExpressionWriter {
  const Formula& formula;
  const Language& language;

  const std::string& type(ValueKind kind) const {
    static const std::string number = "float";
    return kind == ValueKind::number   ? number
           : kind == ValueKind::vector ? language.vector
                                       : language.colour;
  }

  const std::string& name(const Step& step) const {
    return step.operation == Operation::time ? language.time : step.name;
  }

  /// A step within an expression: its name, or what it is computed from.
  std::string operand(std::size_t step) const {
    const auto& all = formula.steps[step];
    if (!all.name.empty()) return name(all);
    const auto text = expression(step);
    switch (all.operation) {
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
      case Operation::divide:
        return "(" + text + ")";
      default:
        return all.operation == Operation::constant && text.starts_with('-') ? "(" + text + ")"
                                                                             : text;
    }
  }

  std::string expression(std::size_t step) const {
    const auto& all = formula.steps[step];
    const auto of = [&](std::size_t i) { return operand(all.operands[i]); };
    const auto bare = [&](std::size_t i) {
      const auto& part = formula.steps[all.operands[i]];
      return part.name.empty() ? expression(all.operands[i]) : name(part);
    };
    switch (all.operation) {
      case Operation::place:
      case Operation::time:
        return name(all);
      case Operation::constant:
        if (all.kind == ValueKind::number) return literal(all.constant[0]);
        return fmt::format("{}({}, {}, {})", language.literal, literal(all.constant[0]),
                           literal(all.constant[1]), literal(all.constant[2]));
      case Operation::add:
        return sum_of(all.operands[0]) + added(all.operands[1]);
      case Operation::subtract:
        return fmt::format("{} - {}", sum_of(all.operands[0]), of(1));
      case Operation::multiply:
        return fmt::format("{} * {}", of(0), of(1));
      case Operation::divide:
        return fmt::format("{} / {}", of(0), of(1));
      case Operation::minimum:
        return fmt::format("min({}, {})", bare(0), bare(1));
      case Operation::clamp:
        return fmt::format("clamp({}, 0.0, 1.0)", bare(0));
      case Operation::dot:
        return fmt::format("dot({}, {})", bare(0), bare(1));
      case Operation::normalize:
        return fmt::format("normalize({})", bare(0));
      case Operation::square_root:
        return fmt::format("sqrt({})", bare(0));
      case Operation::arc_tangent:
        return fmt::format("{}({}, {})", language.arc_tangent, bare(0), bare(1));
      case Operation::floor:
        return fmt::format("floor({})", bare(0));
      case Operation::mix:
        return fmt::format("mix({}, {}, {})", bare(0), bare(1), bare(2));
      case Operation::texel:
        return fmt::format(fmt::runtime(language.texel), bare(0), bare(1));
    }
    return {};
  }

  /// Operand of a sum or difference that needs no parentheses where it is a product, or a sum that stands first.
  std::string sum_of(std::size_t step, bool first = true) const {
    const auto& all = formula.steps[step];
    const bool sum = all.operation == Operation::add || all.operation == Operation::subtract,
               product = all.operation == Operation::multiply || all.operation == Operation::divide;
    return all.name.empty() && (product || (first && sum)) ? expression(step) : operand(step);
  }

  /// Second operand of a sum with its sign.
  std::string added(std::size_t step) const {
    const auto& all = formula.steps[step];
    const bool negative = all.operation == Operation::constant && all.name.empty() &&
                          all.kind == ValueKind::number && all.constant[0] < 0;
    return negative ? " - " + literal(-all.constant[0]) : " + " + sum_of(step, false);
  }

  /// Named steps as lines, without the inputs and the result.
  std::string lines() const {
    std::string text;
    for (std::size_t i = 0; i < formula.result(); ++i) {
      const auto& step = formula.steps[i];
      const bool input = step.operation == Operation::place || step.operation == Operation::time;
      if (step.name.empty() || input) continue;
      if (!step.meaning.empty()) text += fmt::format("  // {}\n", step.meaning);
      text += fmt::format("  {} {} = {};\n", type(step.kind), step.name, expression(i));
    }
    return text;
  }
};

/// What every shader's head says.
std::string head_of(const ShaderHead& head, const Language& language) {
  return fmt::format(
      "// SPDX-License-Identifier: MIT\n"
      "// {}: light on the Moon over full sunlight, made by coppermoon.\n"
      "//\n"
      "//   place    point of the Moon on Moon-fixed axes, of any length: +X longitude 0, +Y 90 "
      "degrees east, +Z north\n"
      "//   {:<8} seconds from greatest eclipse, {} UTC\n"
      "//   light    factor on the sunlit Moon, no unit, 1 in full sunlight; red, green and blue "
      "of "
      "{}\n"
      "//\n",
      head.title, language.time, head.greatest, head.colour_space);
}

}  // namespace

std::string glsl_of(const Formula& formula, const ShaderHead& head) {
  const ExpressionWriter write{formula, glsl};
  return head_of(head, write.language) +
         fmt::format(
             "// eclipse_strip is {}, its rows uploaded from the image's top, as numbers (no "
             "sRGB), filtered linearly,\n"
             "// clamped at its edges, without mipmaps; half floats (RGB16F) are enough.\n"
             "uniform sampler2D eclipse_strip;\n\n"
             "vec3 eclipse_light(vec3 place, float time) {{\n{}  return {};\n}}\n",
             head.strip, write.lines(), write.expression(formula.result()));
}

std::string osl_of(const Formula& formula, const ShaderHead& head) {
  const ExpressionWriter write{formula, osl};
  return head_of(head, write.language) +
         fmt::format(
             "shader eclipse(\n"
             "    string strip = \"{}\" [[ string widget = \"filename\" ]],\n"
             "    vector place = transform(\"object\", P),\n"
             "    float seconds = 0,\n"
             "    output color light = 1)\n"
             "{{\n{}  light = {};\n}}\n",
             head.strip, write.lines(), write.expression(formula.result()));
}

}  // namespace coppermoon::uses
