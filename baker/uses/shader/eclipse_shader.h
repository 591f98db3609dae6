// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algebra/progress.h"
#include "eclipse/contacts.h"
#include "uses/shader/formula.h"

namespace coppermoon::uses {

/// An eclipse as one small image and the formula that reads it.
struct EclipseShader {
  eclipse::Eclipse eclipse;                ///< its greatest phase at a whole second
  std::optional<almanac::Instant> moment;  ///< that is held; without: the whole eclipse
  ShadowMotion motion;
  LightStrip strip;
  Formula formula;
};

/// Shader of an eclipse, or of one moment of it: one plane through the middle of the Moon's near half.
///
/// Accuracy  a sunlit Moon times the light is within the strip's error of the brightest channel of a baked Moon, beside
///           that one's own error; where ground has another colour than the Moon's mean, 1 % more in the umbra
/// Throws    Error  as light_strip
EclipseShader eclipse_shader(const eclipse::Eclipse& eclipse, const ShaderRequest& request,
                             const algebra::Progress& progress = {},
                             const std::optional<almanac::Instant>& moment = {});

/// Writes a shader's strip, .exr.
///
/// Given  recipe  for its header; empty: none
void write_strip(const std::filesystem::path& file, const EclipseShader& shader,
                 const ShaderRequest& request, const std::string& recipe);

/// Writes a shader's files into a folder: eclipse.exr, the strip; eclipse.osl, .glsl, .mtlx; eclipse.inc and
/// eclipse.pov for POV-Ray; eclipse.json, the formula step by step with all facts, for other programs.
///
/// Given     recipe  for the strip's header
/// Returned  names of the files
/// Throws    Error   when a file there is not ours, or cannot be written
std::vector<std::string> write_shader(const std::filesystem::path& folder,
                                      const EclipseShader& shader, const ShaderRequest& request,
                                      const std::string& recipe);

}  // namespace coppermoon::uses
