// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "texture/write_image.h"
#include "verbs/moon_options.h"
#include "verbs/observer_options.h"

namespace coppermoon::verbs {

/// A scene made: what it holds, and for whom.
struct LitScene {
  BakedMoon moon;
  View view;
};

/// The view, and the Moon ready to be baked: all of a scene but its files.
LitScene lit_scene(const MoonOptions& moon, const ViewOptions& view, const std::string& recipe,
                   texture::Extent extent = texture::Extent::whole);

/// Bakes the texture, and writes it, scene and settings into a folder, made when only its last part
/// is missing; a folder made so is gone again when they cannot be written.
void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const texture::ExrOptions& options = {});

}  // namespace coppermoon::verbs
