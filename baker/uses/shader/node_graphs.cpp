// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

const char* word(Operation operation) {
  switch (operation) {
    case Operation::place:
      return "place";
    case Operation::time:
      return "time";
    case Operation::constant:
      return "constant";
    case Operation::add:
      return "add";
    case Operation::subtract:
      return "subtract";
    case Operation::multiply:
      return "multiply";
    case Operation::divide:
      return "divide";
    case Operation::minimum:
      return "min";
    case Operation::clamp:
      return "clamp";
    case Operation::dot:
      return "dotproduct";
    case Operation::normalize:
      return "normalize";
    case Operation::square_root:
      return "sqrt";
    case Operation::arc_tangent:
      return "atan2";
    case Operation::floor:
      return "floor";
    case Operation::mix:
      return "mix";
    case Operation::texel:
      return "image";
  }
  return "";
}

std::string name_of(const Formula& formula, std::size_t step) {
  const auto& name = formula.steps[step].name;
  return name.empty() ? fmt::format("step_{}", step + 1) : name;
}

const char* type_of(ValueKind kind) {
  return kind == ValueKind::number ? "float" : kind == ValueKind::vector ? "vector3" : "color3";
}

std::string value_of(const Step& constant) {
  const auto& c = constant.constant;
  return constant.kind == ValueKind::number
             ? fmt::format("{:.9g}", c[0])
             : fmt::format("{:.9g}, {:.9g}, {:.9g}", c[0], c[1], c[2]);
}

/// An input of a node, as MaterialX has it.
std::string input(const Formula& formula, const std::string& name, std::size_t step) {
  const auto& from = formula.steps[step];
  const auto source =
      from.operation == Operation::constant ? fmt::format("value=\"{}\"", value_of(from))
      : from.operation == Operation::time   ? std::string("interfacename=\"time\"")
                                          : fmt::format("nodename=\"{}\"", name_of(formula, step));
  return fmt::format("      <input name=\"{}\" type=\"{}\" {} />\n", name, type_of(from.kind),
                     source);
}

std::vector<std::string> input_names(Operation operation, std::size_t count) {
  if (operation == Operation::arc_tangent) return {"iny", "inx"};
  if (operation == Operation::mix) return {"bg", "fg", "mix"};
  if (count == 1) return {"in"};
  return {"in1", "in2"};
}

std::string node(const Formula& formula, std::size_t i) {
  const auto& step = formula.steps[i];
  const auto name = name_of(formula, i);
  std::string inputs;
  if (step.operation == Operation::place)
    return fmt::format(
        "    <position name=\"{}\" type=\"vector3\">\n"
        "      <input name=\"space\" type=\"string\" value=\"object\" />\n    </position>\n",
        name);
  if (step.operation == Operation::texel)
    return fmt::format(
        "    <subtract name=\"{0}_v\" type=\"float\">\n"
        "      <input name=\"in1\" type=\"float\" value=\"1\" />\n{1}    </subtract>\n"
        "    <combine2 name=\"{0}_uv\" type=\"vector2\">\n{2}"
        "      <input name=\"in2\" type=\"float\" nodename=\"{0}_v\" />\n    </combine2>\n"
        "    <image name=\"{0}\" type=\"color3\">\n"
        "      <input name=\"file\" type=\"filename\" interfacename=\"strip\" />\n"
        "      <input name=\"texcoord\" type=\"vector2\" nodename=\"{0}_uv\" />\n"
        "      <input name=\"uaddressmode\" type=\"string\" value=\"clamp\" />\n"
        "      <input name=\"vaddressmode\" type=\"string\" value=\"clamp\" />\n"
        "      <input name=\"filtertype\" type=\"string\" value=\"linear\" />\n    </image>\n",
        name, input(formula, "in2", step.operands[1]), input(formula, "in1", step.operands[0]));
  const auto names = input_names(step.operation, step.operands.size());
  for (std::size_t k = 0; k < step.operands.size(); ++k)
    inputs += input(formula, names[k], step.operands[k]);
  return fmt::format("    <{0} name=\"{1}\" type=\"{2}\">\n{3}    </{0}>\n", word(step.operation),
                     name, type_of(step.kind), inputs);
}

}  // namespace

std::string materialx_of(const Formula& formula, const ShaderHead& head) {
  std::string nodes;
  for (std::size_t i = 0; i < formula.steps.size(); ++i) {
    const auto& step = formula.steps[i];
    if (step.operation == Operation::constant || step.operation == Operation::time) continue;
    if (!step.meaning.empty()) nodes += fmt::format("    <!-- {} -->\n", step.meaning);
    nodes += node(formula, i);
  }
  return fmt::format(
      R"(<?xml version="1.0"?>
<!-- SPDX-License-Identifier: MIT -->
<!-- {}: light on the Moon over full sunlight, made by coppermoon. A factor on the sunlit Moon, no unit; red, green and
     blue of {}. `time` is seconds from greatest eclipse, {} UTC. The Moon is a sphere around the origin of object
     space: +X longitude 0, +Y 90 degrees east, +Z north. -->
<materialx version="1.38">
  <nodegraph name="eclipse_shadow">
    <input name="time" type="float" value="0" />
    <input name="strip" type="filename" value="{}" />
{}    <output name="out" type="color3" nodename="{}" />
  </nodegraph>
</materialx>
)",
      head.title, head.colour_space, head.greatest, head.strip, nodes,
      name_of(formula, formula.result()));
}

namespace {

/// Types of USD.
const char* usd_type(ValueKind kind) {
  return kind == ValueKind::number ? "float" : kind == ValueKind::vector ? "float3" : "color3f";
}

/// Node definition of MaterialX for a step.
std::string definition(const Formula& formula, const Step& step) {
  const bool scaled =
      step.operation == Operation::multiply && formula.steps[step.operands[1]].kind != step.kind;
  const auto kind = step.operation == Operation::dot ? ValueKind::vector : step.kind;
  return fmt::format("ND_{}_{}{}", word(step.operation), type_of(kind), scaled ? "FA" : "");
}

std::string shader_prim(const std::string& name, const std::string& id, const std::string& inputs,
                        const char* type) {
  return fmt::format(
      "                def Shader \"{}\"\n                {{\n"
      "                    uniform token info:id = \"{}\"\n{}"
      "                    {} outputs:out\n                }}\n\n",
      name, id, inputs, type);
}

}  // namespace

UsdNodes usd_of(const Formula& formula, const std::string& scope, const std::string& strip) {
  const auto input = [&](const std::string& name, std::size_t of) {
    const auto& from = formula.steps[of];
    const auto declared =
        fmt::format("                    {} inputs:{}", usd_type(from.kind), name);
    if (from.operation == Operation::time)
      return fmt::format("{}.connect = <{}.inputs:time>\n", declared, scope);
    if (from.operation != Operation::constant)
      return fmt::format("{}.connect = <{}/{}.outputs:out>\n", declared, scope,
                         name_of(formula, of));
    const auto& c = from.constant;  // y, z, x stand for x, y, z
    return from.kind == ValueKind::number
               ? fmt::format("{} = {:.9g}\n", declared, c[0])
               : fmt::format("{} = ({:.9g}, {:.9g}, {:.9g})\n", declared, c[1], c[2], c[0]);
  };
  UsdNodes nodes;
  for (std::size_t i = 0; i < formula.steps.size(); ++i) {
    const auto& step = formula.steps[i];
    const auto name = name_of(formula, i);
    std::string inputs;
    switch (step.operation) {
      case Operation::constant:
      case Operation::time:
        continue;
      case Operation::place:
        nodes.prims +=
            shader_prim(name, "ND_position_vector3",
                        "                    string inputs:space = \"object\"\n", "float3");
        continue;
      case Operation::texel: {
        nodes.prims += shader_prim(
            name + "_v", "ND_subtract_float",
            "                    float inputs:in1 = 1\n" + input("in2", step.operands[1]), "float");
        nodes.prims += shader_prim(
            name + "_uv", "ND_combine2_vector2",
            input("in1", step.operands[0]) +
                fmt::format(
                    "                    float inputs:in2.connect = <{}/{}_v.outputs:out>\n", scope,
                    name),
            "float2");
        nodes.prims += shader_prim(
            name, "ND_image_color3",
            fmt::format(
                "                    asset inputs:file = {} (\n"
                "                        colorSpace = \"data\"\n                    )\n"
                "                    float2 inputs:texcoord.connect = <{}/{}_uv.outputs:out>\n"
                "                    string inputs:uaddressmode = \"clamp\"\n"
                "                    string inputs:vaddressmode = \"clamp\"\n",
                strip, scope, name),
            "color3f");
        continue;
      }
      default:
        break;
    }
    const auto names = input_names(step.operation, step.operands.size());
    for (std::size_t k = 0; k < step.operands.size(); ++k)
      inputs += input(names[k], step.operands[k]);
    nodes.prims += shader_prim(name, definition(formula, step), inputs, usd_type(step.kind));
  }
  nodes.output = fmt::format("{}/{}.outputs:out", scope, name_of(formula, formula.result()));
  return nodes;
}

nlohmann::ordered_json json_of(const Formula& formula) {
  auto steps = nlohmann::ordered_json::array();
  for (const auto& step : formula.steps) {
    nlohmann::ordered_json one{
        {"operation", word(step.operation)}, {"kind", type_of(step.kind)}, {"from", step.operands}};
    if (step.operation == Operation::constant && step.kind == ValueKind::number)
      one["value"] = step.constant[0];
    else if (step.operation == Operation::constant)
      one["value"] = step.constant;
    if (!step.name.empty()) one["name"] = step.name;
    steps.push_back(std::move(one));
  }
  return steps;
}

}  // namespace coppermoon::uses
