// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "uses/picture/baked_moon.h"

namespace coppermoon::uses {

/// Recipe, in TOML, with which `coppermoon bake --recipe` bakes the same texels again. The planned work stands in it
/// knob by knob, so they are the same on any machine.
///
/// Omits  a map, as MoonRequest::albedo_map names it, is there by its name alone (files::name_to_share)
std::string texture_recipe(const LitMoon& moon, const TextureContent& content);

}  // namespace coppermoon::uses
