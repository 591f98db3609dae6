// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <vector>

#include "texture/read_image.h"
#include "uses/picture/photo_file.h"
#include "verbs/flags/flags.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {

/// Adds --coding, which says how a photograph's pixel values are converted to light.
inline request::Parameter& add_coding_option(Verb& verb, texture::Coding& coding,
                                             const std::string& help) {
  using texture::coding_words;
  return add_choice<texture::Coding>(verb, "--coding", coding,
                                     {coding_words.begin(), coding_words.end()}, help);
}

/// Reports on stderr each photograph that is read as sRGB because its header names a program that developed it.
inline void warn_of_developers(const std::vector<std::string>& photos, texture::Coding told) {
  if (told != texture::Coding::as_file_says) return;
  for (const auto& photo : photos)
    if (const auto developer = uses::developer_of(photo))
      fmt::print(stderr,
                 "coppermoon: {}: developed by {}, so read as sRGB, as the file says; --coding "
                 "camera takes the "
                 "camera's own tone curve\n",
                 one_line(photo), one_line(*developer));
}

}  // namespace coppermoon::verbs
