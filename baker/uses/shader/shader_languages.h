// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "uses/shader/formula.h"

namespace coppermoon::uses {

/// Information for the comment at the head of a shader.
struct ShaderHead {
  std::string title;           ///< such as "Total eclipse of the Moon, 2018-07-27"
  std::string greatest;        ///< UTC of greatest eclipse
  std::string colour_space;    ///< colour space of the light
  std::string strip;           ///< file name of the strip
  double declination_rad = 0;  ///< of the antisolar point at greatest eclipse
};

/// GLSL function `vec3 eclipse_light(vec3 place, float time)` for OpenGL ES 3, WebGL 2, and OpenGL with GLSL 1.30.
std::string glsl_of(const Formula& formula, const ShaderHead& head);

/// OSL source of a shader named `eclipse`.
std::string osl_of(const Formula& formula, const ShaderHead& head);

/// MaterialX document that contains the node graph `eclipse_shadow`.
std::string materialx_of(const Formula& formula, const ShaderHead& head);

/// POV-Ray include file with the macros Eclipse_At and Eclipse_Moon. Its formula is the same as in shadow_formula.
std::string povray_of(const ShadowMotion& motion, const LightStrip& strip, const ShaderHead& head);

/// UsdShade prims that compute the light with MaterialX nodes, for a sphere with north at +Y and longitude 0 at +Z.
///
/// Given     scope  path of the parent prim, whose inputs:time provides the time
///           strip  USD asset value that refers to the light strip
/// Returned  text of the prims, and the path of their output
struct UsdNodes {
  std::string prims, output;
};
UsdNodes usd_of(const Formula& formula, const std::string& scope, const std::string& strip);

/// The formula as a JSON list with one object per step: {"operation", "kind", "from": [operands], "value", "name"}.
nlohmann::ordered_json json_of(const Formula& formula);

}  // namespace coppermoon::uses
