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

/// An eclipse, encoded as one small image and the formula that reads it.
struct EclipseShader {
  eclipse::Eclipse eclipse;                ///< its greatest phase is at a whole second
  std::optional<almanac::Instant> moment;  ///< moment shown; if absent, the whole eclipse
  ShadowMotion motion;
  LightStrip strip;
  Formula formula;
};

/// Shader for an eclipse, or for one moment of it. A moment has one plane, through the middle of the Moon's near half.
///
/// Accuracy  a sunlit Moon times the light differs from a baked Moon by at most the strip's error, relative to the
///           brightest channel, apart from the baked Moon's own error. In the umbra, add 1 % where the ground's colour
///           is not the Moon's mean
/// Throws    Error  as light_strip
EclipseShader eclipse_shader(const eclipse::Eclipse& eclipse, const ShaderRequest& request,
                             const algebra::Progress& progress = {},
                             const std::optional<almanac::Instant>& moment = {});

/// Writes a shader's strip as OpenEXR.
///
/// Given  recipe  for the file's header; if empty, none is written
void write_strip(const std::filesystem::path& file, const EclipseShader& shader,
                 const ShaderRequest& request, const std::string& recipe);

/// Writes a shader's files into a folder: eclipse.exr, the strip; eclipse.osl, .glsl, .mtlx; eclipse.inc and
/// eclipse.pov for POV-Ray; eclipse.json, the formula step by step with all facts, for other programs.
///
/// Given     recipe  for the strip's header
/// Returned  names of the files
/// Throws    Error   when a file in the folder is not one of ours, or cannot be written
std::vector<std::string> write_shader(const std::filesystem::path& folder,
                                      const EclipseShader& shader, const ShaderRequest& request,
                                      const std::string& recipe);

}  // namespace coppermoon::uses
