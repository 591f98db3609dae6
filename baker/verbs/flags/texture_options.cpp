// SPDX-License-Identifier: MIT
#include "verbs/flags/texture_options.h"

namespace coppermoon::verbs {

void add_frame_space_option(CLI::App& verb, colour::WorkingSpace& space) {
  add_parsed(
      verb, "--space", [&space](const std::string& name) { space = colour::working_space(name); },
      "colour space of the scene-linear frame: lin_rec709, acescg or lin_ciexyzd65_scene",
      std::string(colour::name(space)));
}

void add_texture_options(CLI::App& verb, uses::TextureContent& content) {
  const std::string group = "The texture";
  add_parsed(
      verb, "--space",
      [&content](const std::string& name) { content.space = colour::working_space(name); },
      "colour space: lin_rec709, acescg or lin_ciexyzd65_scene; default: the one in the file's "
      "name, as moon_acescg.exr, or lin_rec709")
      .in(group);
  add_choice<texture::ExrType>(
      verb, "--type", content.type,
      {{"half", texture::ExrType::half}, {"float", texture::ExrType::floating}},
      "numbers of a texel: half or float; default: half, float for a spectrum")
      .in(group);
  add_flag(verb, "--spectral", content.spectral_nm,
           "width of spectral bands [nm], 1 to 100, a divisor of 400: an .exr gets the spectral "
           "radiance from 380 to 780 nm too")
      .in(group);
  add_switch(
      verb, "--passes", content.passes,
      "adds parts to an .exr: direct light, refracted light, irradiance, reflectance, albedo")
      .in(group);
}

}  // namespace coppermoon::verbs
