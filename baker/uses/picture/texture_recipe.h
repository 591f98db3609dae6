// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>

#include "request/recipe.h"
#include "uses/picture/baked_moon.h"

namespace coppermoon::uses {

/// Recipe, in TOML, for the moment, the ground and the light of a Moon.
///
/// Given  with_width  whether to include the width of the texture
///        more        adds further parameters; the fields they are bound to must outlive the call
std::string recipe_of_light(const LitMoon& moon, bool with_width,
                            const std::function<void(request::Parameters&)>& more);

/// The recipe by which a Moon was requested. If the Moon is in shadow, the settings planned for its light are added.
request::Recipe recipe_made(const request::Recipe& asked, const LitMoon& moon);

/// The recipe with the width of a texture added [texels].
request::Recipe with_width(const request::Recipe& recipe, std::size_t width);

/// Recipe, in TOML, with which `coppermoon bake --recipe` bakes the same texels again. It lists every setting that was
/// planned, so the texels are the same on any machine.
///
/// Omits  the contents of the map (MoonRequest::albedo_map), which is only named (files::name_to_share)
std::string texture_recipe(const LitMoon& moon, const TextureContent& content);

}  // namespace coppermoon::uses
