// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "verbs/moon_options.h"
#include "verbs/observer_options.h"

namespace coppermoon::verbs {

/// A scene made: what it holds, and for whom.
struct LitScene {
  BakedMoon moon;
  View view;
};

/// Bakes the Moon and computes the view: all of a scene but its files.
LitScene lit_scene(const MoonOptions& moon, const ViewOptions& view, const std::string& recipe);

/// Writes texture, scene and settings into a folder, made when only its last part is missing; a
/// folder made so is gone again when they cannot be written.
void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene);

}  // namespace coppermoon::verbs
