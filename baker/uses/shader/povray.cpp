// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "uses/shader/shader_languages.h"

namespace coppermoon::uses {
namespace {

constexpr std::array axis_names{"x", "y", "z"};
constexpr std::array channel_names{"red", "green", "blue"};
constexpr std::array functions{"Eclipse_Red", "Eclipse_Green", "Eclipse_Blue"};

/// Name in POV-Ray, whose own words are in small letters: "to_east" is "To_east".
std::string capital(std::string name) {
  name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

/// Writer of a formula as functions of POV-Ray, which know numbers alone. A named step that is used more than once
/// becomes a parameter of the function that goes on from it.
class FunctionWriter {
 public:
  explicit FunctionWriter(const Formula& formula) : formula_(formula), uses_(formula.steps.size()) {
    for (const auto& step : formula.steps)
      for (const auto operand : step.operands) ++uses_[operand];
    // a vector is read once for each of its components
    for (std::size_t i = 0; i < formula.result(); ++i)
      if (bound(i)) order_.push_back(i);
  }

  /// Values that hold for one moment.
  std::string constants() const {
    std::string text;
    for (std::size_t i = 0; i < formula_.steps.size(); ++i) {
      const auto& step = formula_.steps[i];
      if (step.name.empty() || formula_.varies(i) || step.operation == Operation::time) continue;
      const auto name = capital(step.name);
      if (step.kind == ValueKind::number) {
        text += fmt::format("  #declare Eclipse_{} = {};\n", name, of(i, 0, true));
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c)
        text +=
            fmt::format("  #declare Eclipse_{}_{} = {};\n", name, axis_names[c], of(i, c, true));
    }
    return text;
  }

  /// Functions of x, y, z for one channel, the last of them under its name.
  std::string channel(std::size_t c) {
    channel_ = c;
    std::vector<std::string> lines;
    auto live = needed(formula_.result());
    auto body = of(formula_.result(), c, true);
    for (std::size_t i = order_.size(); i-- > 0;) {
      const auto step = order_[i];
      if (!live.contains(step)) continue;
      const auto name = fmt::format("{}_{}", functions[c], i + 1);
      lines.push_back(declared(name, fmt::format("{}", fmt::join(parameters(live), ", ")), body));
      std::vector<std::string> arguments;
      for (const auto value : live)
        for (std::size_t k = 0; k < components(value); ++k)
          arguments.push_back(value == step ? of(step, component(step, k), true)
                                            : variable(value, k));
      body = fmt::format("{}({})", name, fmt::join(arguments, ", "));
      live.erase(step);
      live.merge(needed(step));
    }
    lines.push_back(declared(functions[c], "x, y, z", body));
    return fmt::format("{}", fmt::join(lines, ""));
  }

 private:
  using Steps = std::set<std::size_t>;

  /// Declaration of a function, which POV-Ray does not let be declared twice.
  static std::string declared(const std::string& name, const std::string& parameters,
                              const std::string& body) {
    return fmt::format("  #ifdef ({0}) #undef {0} #end\n  #declare {0} = function({1}) {{ {2} }}\n",
                       name, parameters, body);
  }

  bool bound(std::size_t step) const {
    const auto& all = formula_.steps[step];
    return !all.name.empty() && all.operation != Operation::place && formula_.varies(step) &&
           uses_[step] > 1;
  }

  std::size_t components(std::size_t step) const {
    return formula_.steps[step].kind == ValueKind::vector ? 3 : 1;
  }
  std::size_t component(std::size_t step, std::size_t k) const {
    return formula_.steps[step].kind == ValueKind::colour ? channel_ : k;
  }

  std::string variable(std::size_t step, std::size_t k) const {
    const auto name = capital(formula_.steps[step].name);
    return components(step) == 1 ? name : fmt::format("{}_{}", name, axis_names[k]);
  }

  std::vector<std::string> parameters(const Steps& live) const {
    std::vector<std::string> names;
    for (const auto step : live)
      for (std::size_t k = 0; k < components(step); ++k) names.push_back(variable(step, k));
    return names;
  }

  /// Bound steps that a step's own expression reads.
  Steps needed(std::size_t step) const {
    Steps all;
    for (const auto operand : formula_.steps[step].operands) {
      if (bound(operand))
        all.insert(operand);
      else
        all.merge(needed(operand));
    }
    return all;
  }

  /// A component of a step: its name, or, where its definition is asked for, an expression.
  std::string of(std::size_t step, std::size_t c, bool defined = false) const {
    const auto& all = formula_.steps[step];
    const auto operand = [&](std::size_t i) {
      const auto kind = formula_.steps[all.operands[i]].kind;
      return of(all.operands[i], kind == ValueKind::number ? 0 : c);
    };
    const auto infix = [&](char sign) {
      return fmt::format("({} {} {})", operand(0), sign, operand(1));
    };
    if (!defined && bound(step)) return variable(step, c);
    if (!defined && !all.name.empty() && !formula_.varies(step)) {
      if (all.operation == Operation::time) return "Time";
      const auto name = "Eclipse_" + capital(all.name);
      return all.kind == ValueKind::number ? name : fmt::format("{}_{}", name, axis_names[c]);
    }
    switch (all.operation) {
      case Operation::place:  // y is north, z 90 degrees east
        return std::array{"x", "z", "y"}[c];
      case Operation::time:
        return "Time";
      case Operation::constant:
        return fmt::format("{:.9g}", all.constant[c]);
      case Operation::add:
        return infix('+');
      case Operation::subtract:
        return infix('-');
      case Operation::multiply:
        return infix('*');
      case Operation::divide:
        return infix('/');
      case Operation::minimum:
        return fmt::format("min({}, {})", operand(0), operand(1));
      case Operation::clamp:
        return fmt::format("min(max({}, 0), 1)", operand(0));
      case Operation::dot: {
        std::vector<std::string> products;
        for (std::size_t k = 0; k < 3; ++k)
          products.push_back(fmt::format("{}*{}", of(all.operands[0], k), of(all.operands[1], k)));
        return fmt::format("({})", fmt::join(products, " + "));
      }
      case Operation::normalize: {
        std::vector<std::string> squares;
        for (std::size_t k = 0; k < 3; ++k)
          squares.push_back(fmt::format("{0}*{0}", of(all.operands[0], k)));
        return fmt::format("{}/sqrt({})", operand(0), fmt::join(squares, " + "));
      }
      case Operation::square_root:
        return fmt::format("sqrt({})", operand(0));
      case Operation::arc_tangent:
        return fmt::format("atan2({}, {})", operand(0), operand(1));
      case Operation::floor:
        return fmt::format("floor({})", operand(0));
      case Operation::mix:
        return fmt::format("({0} + ({1} - {0})*{2})", operand(0), operand(1), operand(2));
      case Operation::texel:
        return fmt::format("Eclipse_Strip({}, 1 - {}, 0).{}", operand(0), operand(1),
                           channel_names[c]);
    }
    return {};
  }

  const Formula& formula_;
  std::vector<int> uses_;
  std::vector<std::size_t> order_;
  std::size_t channel_ = 0;
};

}  // namespace

std::string povray_of(const Formula& formula, const ShaderHead& head) {
  FunctionWriter write(formula);
  auto text = fmt::format(
      R"(// SPDX-License-Identifier: MIT
// {0}: light on the Moon over full sunlight, made by coppermoon for POV-Ray 3.7.
//
//   #version 3.7;
//   global_settings {{ assumed_gamma 1.0 }}
//   #include "{2}.inc"
//   Eclipse_At(clock)
//   camera {{
//     location Eclipse_Distance*Eclipse_Earth direction z right x*image_width/image_height up y
//     sky Eclipse_North angle 0.8 look_at 0
//   }}
//   Eclipse_Moon(pigment {{ rgb 900 }})
//
// eclipse.pov is this scene: `povray eclipse.pov +KFF24 +KI-11400 +KF11400 +FE` renders a film of 24 frames.
//
// The Moon is a sphere of radius 1: longitude 0 at x, 90 degrees east at z, north at y (as in coppermoon.inc).

#declare Eclipse_Strip = function {{ pigment {{ image_map {{ exr "{2}.exr" interpolate 2 once }} }} }}

// The shadow at a time: seconds from greatest eclipse, {1} UTC. Declares
//   Eclipse_Red, Eclipse_Green, Eclipse_Blue   functions of x, y, z: factors on the sunlit Moon, 1 in full sunlight;
//                                              red, green and blue of {3}
//   Eclipse_Earth, Eclipse_North, Eclipse_Sun  directions from the Moon's centre: the Earth's centre, the celestial
//                                              pole and the Sun, unit
//   Eclipse_Distance                           of the Earth's centre, in lunar radii
#macro Eclipse_At(Time)
)",
      head.title, head.greatest, head.strip.substr(0, head.strip.rfind('.')), head.colour_space);
  text += write.constants();
  for (std::size_t c = 0; c < 3; ++c) text += write.channel(c);
  text += fmt::format("  #local Declination = {:.7g};  // of the point opposite to the Sun\n",
                      head.declination_rad);
  return text + R"(  #local East = <Eclipse_East_x, Eclipse_East_z, Eclipse_East_y>;
  #local North = <Eclipse_North_x, Eclipse_North_z, Eclipse_North_y>;
  #declare Eclipse_Sun = -<Eclipse_Away_x, Eclipse_Away_z, Eclipse_Away_y>;
  #declare Eclipse_North = cos(Declination)*North - sin(Declination)*Eclipse_Sun;
  #local To_Earth = Eclipse_Centre_depth*Eclipse_Sun - Eclipse_Centre_east*East
                    - Eclipse_Centre_north*North;
  #declare Eclipse_Earth = vnormalize(To_Earth);
  #declare Eclipse_Distance = vlength(To_Earth);
#end

// The Moon, luminous: a pigment of the sunlit Moon, in cd/m2 up to 20000, times the light of Eclipse_At.
#macro Eclipse_Moon(Sunlit)
  #local Most = 20000;  // what a pigment's function has for 1
  #local Sunlit_Map = function { pigment { Sunlit } }
  sphere {
    0, 1
    pigment {
      average
      pigment_map {
        [ 1 function { min(Sunlit_Map(x, y, z).red*Eclipse_Red(x, y, z)/Most, 0.999999) }
          colour_map { [ 0 rgb 0 ] [ 1 rgb <3*Most, 0, 0> ] } ]
        [ 1 function { min(Sunlit_Map(x, y, z).green*Eclipse_Green(x, y, z)/Most, 0.999999) }
          colour_map { [ 0 rgb 0 ] [ 1 rgb <0, 3*Most, 0> ] } ]
        [ 1 function { min(Sunlit_Map(x, y, z).blue*Eclipse_Blue(x, y, z)/Most, 0.999999) }
          colour_map { [ 0 rgb 0 ] [ 1 rgb <0, 0, 3*Most> ] } ]
      }
    }
    finish { ambient 0 diffuse 0 emission 1 }
    no_shadow
  }
#end
)";
}

}  // namespace coppermoon::uses
