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

/// Data for an eclipse's shader: a small image of the light in the shadow, and the formula that reads the image.
struct EclipseShader {
  eclipse::Eclipse eclipse;                ///< its greatest eclipse is rounded to a second
  std::optional<almanac::Instant> moment;  ///< moment shown; if absent, the whole eclipse
  ShadowMotion motion;
  LightStrip strip;
  Formula formula;
};

/// Makes the shader for a whole eclipse, or for one moment of it. For one moment, the light is computed in a single
/// plane, which passes through the middle of the Moon's near half.
///
/// Accuracy  The sunlit Moon multiplied by the shader's light differs from a baked Moon by at most LightStrip::error,
///           relative to the brightest channel, plus the baked Moon's own error. In the umbra, add 1 % for ground whose
///           colour is not the Moon's mean colour
/// Throws    Error  if light_strip does
EclipseShader eclipse_shader(const eclipse::Eclipse& eclipse, const ShaderRequest& request,
                             const algebra::Progress& progress = {},
                             const std::optional<almanac::Instant>& moment = {});

/// Writes a shader's light strip as an OpenEXR file.
///
/// Given  recipe  settings to record in the file's header; if empty, none are recorded
void write_strip(const std::filesystem::path& file, const EclipseShader& shader,
                 const ShaderRequest& request, const std::string& recipe);

/// Writes a shader's files into a folder. The light strip is eclipse.exr. The shaders are eclipse.osl, eclipse.glsl
/// and eclipse.mtlx, with eclipse.inc and eclipse.pov for POV-Ray. eclipse.json has the formula's steps and all data.
///
/// Given     recipe  settings to record in the strip's header
/// Returned  names of the files written
/// Throws    Error   if a file cannot be written, or would replace a file that was not made by coppermoon
std::vector<std::string> write_shader(const std::filesystem::path& folder,
                                      const EclipseShader& shader, const ShaderRequest& request,
                                      const std::string& recipe);

}  // namespace coppermoon::uses
