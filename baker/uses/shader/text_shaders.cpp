// SPDX-License-Identifier: MIT
#include <fmt/args.h>
#include <fmt/format.h>

#include <map>

#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

/// Names and expressions of a shading language whose syntax is like C's. To support another one, add a Language.
struct Language {
  std::string vector, colour;                  ///< names of the types
  std::string time;                            ///< name of the time parameter
  std::map<std::string, const char*> words{};  ///< expression for each operation
};

/// Expressions for the operations that are written alike in all these languages.
const std::map<std::string, const char*> common_words{
    {"place", "place"},
    {"add", "{} + {}"},
    {"subtract", "{} - {}"},
    {"multiply", "{} * {}"},
    {"divide", "{} / {}"},
    {"min", "min({}, {})"},
    {"clamp", "clamp({}, 0.0, 1.0)"},
    {"dotproduct", "dot({}, {})"},
    {"normalize", "normalize({})"},
    {"sqrt", "sqrt({})"},
    {"floor", "floor({})"},
    {"mix", "mix({}, {}, {})"},
};

const Language glsl{
    "vec3",
    "vec3",
    "time",
    {{"atan2", "atan({}, {})"}, {"image", "texture(eclipse_strip, vec2({}, {})).rgb"}},
};

const Language osl{
    "vector",
    "color",
    "seconds",  // OSL has its own `time`
    {{"atan2", "atan2({}, {})"},
     {"image",
      "(color)texture(strip, {}, {}, \"width\", 0, \"blur\", 0, \"wrap\", \"clamp\", "
      "\"interp\", \"linear\")"}},
};

std::string literal(double number) {
  auto text = fmt::format("{:.9g}", number);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

/// How tightly an expression binds, from loosest to tightest. This decides where parentheses are needed.
enum class Binding { sum, product, whole };

Binding binding(const std::string& operation) {
  if (operation == "add" || operation == "subtract") return Binding::sum;
  return operation == "multiply" || operation == "divide" ? Binding::product : Binding::whole;
}

/// Writes a formula's steps as source code.
struct ExpressionWriter {
  const Formula& formula;
  const Language& language;

  /// Source text for an operand: its name or, if it has none, its expression, in parentheses if needed.
  std::string operand(std::size_t step, Binding needed) const {
    const auto& part = formula[step];
    if (part.operation == "time") return language.time;
    if (!part.name.empty()) return part.name;
    const auto text = expression(step);
    const auto bound = text.starts_with('-') ? Binding::sum : binding(part.operation);
    return bound < needed ? "(" + text + ")" : text;
  }

  std::string expression(std::size_t step) const {
    const auto& all = formula[step];
    const auto& [x, y, z] = all.constant;
    if (all.operation == "constant")
      return all.type == number_type ? literal(x)
                                     : fmt::format("{}({}, {}, {})", language.vector, literal(x),
                                                   literal(y), literal(z));
    const auto found = language.words.find(all.operation);
    const auto* words =
        found == language.words.end() ? common_words.at(all.operation) : found->second;
    fmt::dynamic_format_arg_store<fmt::format_context> operands;
    const auto own = binding(all.operation);
    for (std::size_t k = 0; k < all.operands.size(); ++k) {
      const auto needed = own == Binding::product        ? Binding::whole
                          : own == Binding::sum && k > 0 ? Binding::product
                                                         : Binding::sum;
      auto text = operand(all.operands[k], needed);
      if (all.operation == "add" && k == 1 && text.starts_with("(-") &&
          formula[all.operands[k]].operation == "constant") {
        words = common_words.at("subtract");
        text = text.substr(2, text.size() - 3);
      }
      operands.push_back(text);
    }
    return fmt::vformat(words, operands);
  }

  /// Lines of code that assign the named steps to variables. The inputs and the result are left out.
  std::string lines() const {
    const std::map<std::string, std::string> types{
        {number_type, "float"}, {vector_type, language.vector}, {colour_type, language.colour}};
    std::string text;
    for (std::size_t i = 0; i + 1 < formula.size(); ++i) {
      const auto& step = formula[i];
      if (step.name.empty() || step.operands.empty()) continue;
      if (!step.meaning.empty()) text += fmt::format("  // {}\n", step.meaning);
      text += fmt::format("  {} {} = {};\n", types.at(step.type), step.name, expression(i));
    }
    return text;
  }

  std::string result() const { return expression(formula.size() - 1); }
};

/// Comment at the head of a shader's source.
std::string head_of(const ShaderHead& head, const Language& language) {
  return fmt::format(
      R"(// SPDX-License-Identifier: MIT
// {}: light on the Moon over full sunlight, made by coppermoon.
//
//   place    point of the Moon on Moon-fixed axes, of any length: +X longitude 0, +Y 90 degrees east, +Z north
//   {:<8} seconds from greatest eclipse, {} UTC
//   light    factor on the sunlit Moon, no unit, 1 in full sunlight; red, green and blue of {}
//
)",
      head.title, language.time, head.greatest, head.colour_space);
}

}  // namespace

std::string glsl_of(const Formula& formula, const ShaderHead& head) {
  const ExpressionWriter write{formula, glsl};
  return head_of(head, glsl) +
         fmt::format(
             R"(// eclipse_strip is {}, its rows uploaded from the image's top, as numbers (no sRGB), filtered linearly,
// clamped at its edges, without mipmaps; half floats (RGB16F) are enough.
uniform sampler2D eclipse_strip;

vec3 eclipse_light(vec3 place, float time) {{
{}  return {};
}}
)",
             head.strip, write.lines(), write.result());
}

std::string osl_of(const Formula& formula, const ShaderHead& head) {
  const ExpressionWriter write{formula, osl};
  return head_of(head, osl) + fmt::format(
                                  R"(shader eclipse(
    string strip = "{}" [[ string widget = "filename" ]],
    vector place = transform("object", P),
    float seconds = 0,
    output color light = 1)
{{
{}  light = {};
}}
)",
                                  head.strip, write.lines(), write.result());
}

}  // namespace coppermoon::uses
