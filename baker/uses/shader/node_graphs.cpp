// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <functional>
#include <map>

#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

/// Input names of those MaterialX nodes whose inputs are not called in1 and in2.
const std::map<std::string, std::vector<const char*>> input_names{
    {"clamp", {"in"}}, {"normalize", {"in"}},     {"sqrt", {"in"}},
    {"floor", {"in"}}, {"atan2", {"iny", "inx"}}, {"mix", {"bg", "fg", "mix"}}};

const std::map<std::string, const char*> usd_types{{"float", "float"},    {"vector2", "float2"},
                                                   {"vector3", "float3"}, {"color3", "color3f"},
                                                   {"string", "string"},  {"filename", "asset"}};

/// An input of a node. It is connected to a constant value, to another node's output, or to an input of the graph.
struct Input {
  enum class From { value, node, graph } from;
  std::string name, type, source;
};

struct Node {
  std::string word, name, type;
  std::vector<Input> inputs{};
  std::string meaning{};
};

std::string name_of(const Formula& formula, std::size_t step) {
  const auto& name = formula[step].name;
  return name.empty() ? fmt::format("step_{}", step + 1) : name;
}

/// Converts a formula into MaterialX nodes.
///
/// Given  vector_format  format string for the three components of a constant vector
std::vector<Node> nodes_of(const Formula& formula, const char* vector_format) {
  using enum Input::From;
  const auto input = [&](const char* name, std::size_t operand) -> Input {
    const auto& step = formula[operand];
    const auto& c = step.constant;
    const auto& type = step.type;
    if (step.operation == "time") return {graph, name, type, "time"};
    if (step.operation != "constant") return {node, name, type, name_of(formula, operand)};
    return {value, name, type,
            type == number_type ? fmt::format("{:.9g}", c[0])
                                : fmt::format(fmt::runtime(vector_format), c[0], c[1], c[2])};
  };
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const auto& step = formula[i];
    const auto name = name_of(formula, i);
    Node made{step.operation, name, step.type, {}, step.meaning};
    if (step.operation == "time" || step.operation == "constant") continue;
    if (step.operation == "place") {
      made.word = "position";
      made.inputs = {{value, "space", "string", "object"}};
    } else if (step.operation == "image") {
      const auto v = name + "_v", uv = name + "_uv";  // MaterialX measures v from the bottom
      nodes.push_back(
          {"subtract", v, "float", {{value, "in1", "float", "1"}, input("in2", step.operands[1])}});
      nodes.push_back(
          {"combine2", uv, "vector2", {input("in1", step.operands[0]), {node, "in2", "float", v}}});
      made.inputs = {{graph, "file", "filename", "strip"},
                     {node, "texcoord", "vector2", uv},
                     {value, "uaddressmode", "string", "clamp"},
                     {value, "vaddressmode", "string", "clamp"},
                     {value, "filtertype", "string", "linear"}};
    } else {
      const auto found = input_names.find(step.operation);
      const auto names =
          found == input_names.end() ? std::vector<const char*>{"in1", "in2"} : found->second;
      for (std::size_t k = 0; k < step.operands.size(); ++k)
        made.inputs.push_back(input(names[k], step.operands[k]));
    }
    nodes.push_back(std::move(made));
  }
  return nodes;
}

}  // namespace

std::string materialx_of(const Formula& formula, const ShaderHead& head) {
  constexpr std::array attributes{"value", "nodename", "interfacename"};
  std::string nodes;
  for (const auto& node : nodes_of(formula, "{:.9g}, {:.9g}, {:.9g}")) {
    if (!node.meaning.empty()) nodes += fmt::format("    <!-- {} -->\n", node.meaning);
    nodes += fmt::format("    <{} name=\"{}\" type=\"{}\">\n", node.word, node.name, node.type);
    for (const auto& input : node.inputs)
      nodes +=
          fmt::format("      <input name=\"{}\" type=\"{}\" {}=\"{}\" />\n", input.name, input.type,
                      attributes[static_cast<std::size_t>(input.from)], input.source);
    nodes += fmt::format("    </{}>\n", node.word);
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
      name_of(formula, formula.size() - 1));
}

UsdNodes usd_of(const Formula& formula, const std::string& scope, const std::string& strip) {
  const auto assigned = [&](const Input& input) -> std::string {
    if (input.from == Input::From::node)
      return fmt::format(".connect = <{}/{}.outputs:out>", scope, input.source);
    if (input.from == Input::From::value)
      return fmt::format(fmt::runtime(input.type == "string" ? " = \"{}\"" : " = {}"),
                         input.source);
    if (input.source == "time") return fmt::format(".connect = <{}.inputs:time>", scope);
    return fmt::format(
        " = {} (\n                        colorSpace = \"data\"\n                    )", strip);
  };
  UsdNodes nodes;
  // vector components are written in the order y, z, x, because north is +Y in USD
  for (const auto& node : nodes_of(formula, "({1:.9g}, {2:.9g}, {0:.9g})")) {
    const auto& [word, name, type, inputs, meaning] = node;
    const bool scaled = word == "multiply" && inputs[0].type != inputs[1].type;
    nodes.prims += fmt::format(
        "                def Shader \"{}\"\n                {{\n"
        "                    uniform token info:id = \"ND_{}_{}{}\"\n",
        name, word, word == "dotproduct" ? inputs[0].type : type, scaled ? "FA" : "");
    for (const auto& input : inputs)
      nodes.prims += fmt::format("                    {} inputs:{}{}\n", usd_types.at(input.type),
                                 input.name, assigned(input));
    nodes.prims += fmt::format("                    {} outputs:out\n                }}\n\n",
                               usd_types.at(type));
  }
  nodes.output = fmt::format("{}/{}.outputs:out", scope, name_of(formula, formula.size() - 1));
  return nodes;
}

nlohmann::ordered_json json_of(const Formula& formula) {
  auto steps = nlohmann::ordered_json::array();
  for (const auto& step : formula) {
    nlohmann::ordered_json one{
        {"operation", step.operation}, {"kind", step.type}, {"from", step.operands}};
    if (step.operation == "constant" && step.type == number_type)
      one["value"] = step.constant[0];
    else if (step.operation == "constant")
      one["value"] = step.constant;
    if (!step.name.empty()) one["name"] = step.name;
    steps.push_back(std::move(one));
  }
  return steps;
}

}  // namespace coppermoon::uses
