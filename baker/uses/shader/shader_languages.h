// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "uses/shader/formula.h"

namespace coppermoon::uses {

/// Facts that a shader's head tells.
struct ShaderHead {
  std::string title;           ///< "Total eclipse of the Moon, 2018-07-27"
  std::string greatest;        ///< UTC
  std::string colour_space;    ///< of the light
  std::string strip;           ///< file name of the strip
  double declination_rad = 0;  ///< of the point opposite to the Sun, at greatest eclipse
};

/// Function of GLSL: `vec3 eclipse_light(vec3 place, float time)`. For OpenGL ES 3, WebGL 2, and OpenGL from 1.3 on.
std::string glsl_of(const Formula& formula, const ShaderHead& head);

/// Shader of OSL, `eclipse`.
std::string osl_of(const Formula& formula, const ShaderHead& head);

/// Document of MaterialX with the node graph `eclipse_shadow`.
std::string materialx_of(const Formula& formula, const ShaderHead& head);

/// Include file for POV-Ray: macros Eclipse_At and Eclipse_Moon. It holds the formula of shadow_formula.
std::string povray_of(const ShadowMotion& motion, const LightStrip& strip, const ShaderHead& head);

/// Prims of UsdShade, MaterialX's nodes, within a scope; their sphere's north is +Y, its longitude 0 +Z.
///
/// Given     scope  path of the prim that holds them; `scope`.inputs:time is the time
///           strip  the strip, as a value of type asset
/// Returned  text of the prims, and the path of the output
struct UsdNodes {
  std::string prims, output;
};
UsdNodes usd_of(const Formula& formula, const std::string& scope, const std::string& strip);

/// The formula for programs: {"operation", "kind", "from": [steps or numbers], "name"} of each step.
nlohmann::ordered_json json_of(const Formula& formula);

}  // namespace coppermoon::uses
