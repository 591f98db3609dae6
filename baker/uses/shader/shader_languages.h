// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "uses/shader/formula.h"

namespace coppermoon::uses {

/// Facts for the comment at the head of a shader.
struct ShaderHead {
  std::string title;           ///< "Total eclipse of the Moon, 2018-07-27"
  std::string greatest;        ///< UTC
  std::string colour_space;    ///< colour space of the light
  std::string strip;           ///< file name of the strip
  double declination_rad = 0;  ///< of the antisolar point at greatest eclipse
};

/// GLSL function `vec3 eclipse_light(vec3 place, float time)` for OpenGL ES 3, WebGL 2, and OpenGL from 1.3 on.
std::string glsl_of(const Formula& formula, const ShaderHead& head);

/// OSL shader named `eclipse`.
std::string osl_of(const Formula& formula, const ShaderHead& head);

/// MaterialX document with the node graph `eclipse_shadow`.
std::string materialx_of(const Formula& formula, const ShaderHead& head);

/// Include file for POV-Ray: macros Eclipse_At and Eclipse_Moon. It contains the same formula as shadow_formula.
std::string povray_of(const ShadowMotion& motion, const LightStrip& strip, const ShaderHead& head);

/// UsdShade prims with MaterialX nodes, inside a scope. On the sphere they shade, north is +Y and longitude 0 is +Z.
///
/// Given     scope  path of the parent prim, whose inputs:time gives the time
///           strip  the strip, as a value of type asset
/// Returned  text of the prims, and the path to their output
struct UsdNodes {
  std::string prims, output;
};
UsdNodes usd_of(const Formula& formula, const std::string& scope, const std::string& strip);

/// The formula as JSON for programs, each step as {"operation", "kind", "from": [steps or numbers], "name"}.
nlohmann::ordered_json json_of(const Formula& formula);

}  // namespace coppermoon::uses
