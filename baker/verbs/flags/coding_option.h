// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "texture/read_image.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// --coding: what a photograph's numbers mean.
inline Flag add_coding_option(CLI::App& verb, texture::Coding& coding, const std::string& help) {
  using enum texture::Coding;
  return add_choice<texture::Coding>(
      verb, "--coding", coding,
      {{"as-file-says", as_file_says}, {"srgb", srgb}, {"linear", linear}, {"camera", camera}},
      help);
}

}  // namespace coppermoon::verbs
