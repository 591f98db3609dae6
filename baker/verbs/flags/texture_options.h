// SPDX-License-Identifier: MIT
#pragma once

#include "uses/picture/baked_moon.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Space, type of numbers, spectrum and passes.
void add_texture_options(CLI::App& verb, uses::TextureContent& content);

}  // namespace coppermoon::verbs
