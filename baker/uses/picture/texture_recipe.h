// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "request/recipe.h"
#include "uses/picture/baked_moon.h"

namespace coppermoon::uses {

/// Recipe, in TOML, of a Moon's moment, ground and light.
///
/// Given  with_width  also the width of its texture
///        more        adds parameters, bound to fields that last until the recipe is made
std::string recipe_of_light(const LitMoon& moon, bool with_width,
                            const std::function<void(request::Parameters&)>& more);

/// Recipe of a Moon that was asked for by another: with the work that its light was planned to be, where it has a shadow.
request::Recipe recipe_made(const request::Recipe& asked, const LitMoon& moon);

/// Recipe with the width of a texture [texels].
request::Recipe with_width(const request::Recipe& recipe, std::size_t width);

/// Recipe, in TOML, with which `coppermoon bake --recipe` bakes the same texels again. The planned work stands in it
/// knob by knob, so they are the same on any machine.
///
/// Omits  a map, as MoonRequest::albedo_map names it, is there by its name alone (files::name_to_share)
std::string texture_recipe(const LitMoon& moon, const TextureContent& content);

}  // namespace coppermoon::uses
