// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/baked_moon.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Space, type of numbers, spectrum and passes.
void add_texture_options(CLI::App& verb, uses::TextureContent& content);

/// --space of a scene-linear frame.
void add_frame_space_option(CLI::App& verb, colour::WorkingSpace& space);

}  // namespace coppermoon::verbs
