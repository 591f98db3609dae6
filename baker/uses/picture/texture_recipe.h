// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "request/parameter.h"
#include "uses/picture/baked_moon.h"

namespace coppermoon::uses {

/// Recipe, in TOML, of a Moon's moment, ground and light.
///
/// Given  with_width  also the width of its texture
///        more        adds parameters, bound to fields that last until the recipe is made
std::string recipe_of_light(const LitMoon& moon, bool with_width,
                            const std::function<void(request::Parameters&)>& more);

/// Recipe, in TOML, with which `coppermoon bake --recipe` bakes the same texels again. The planned work stands in it
/// knob by knob, so they are the same on any machine.
///
/// Omits  a map, as MoonRequest::albedo_map names it, is there by its name alone (files::name_to_share)
std::string texture_recipe(const LitMoon& moon, const TextureContent& content);

}  // namespace coppermoon::uses
