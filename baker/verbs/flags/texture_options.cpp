// SPDX-License-Identifier: MIT
#include "verbs/flags/texture_options.h"

namespace coppermoon::verbs {

void add_texture_options(CLI::App& verb, uses::TextureContent& content) {
  const std::string group = "The texture";
  add_parsed(
      verb, "--space",
      [&content](const std::string& name) { content.space = colour::working_space(name); },
      "lin_rec709, acescg or lin_ciexyzd65_scene; without: what the file's name says, "
      "as moon_acescg.exr, or lin_rec709")
      .in(group);
  add_choice<texture::ExrType>(
      verb, "--type", content.type,
      {{"half", texture::ExrType::half}, {"float", texture::ExrType::floating}},
      "of a texel's numbers: half or float; without: half, or float for a spectrum")
      .in(group);
  add_flag(verb, "--spectral", content.spectral_nm,
           "also spectral radiance, from 380 to 780 nm in bands so wide [nm]: 1 to 100, that "
           "go into 400 evenly; in an .exr")
      .in(group);
  add_switch(verb, "--passes", content.passes,
             "also direct and refracted light, irradiance and reflectance, and the albedo: the "
             "parts of an .exr")
      .in(group);
}

}  // namespace coppermoon::verbs
