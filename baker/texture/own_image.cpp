// SPDX-License-Identifier: MIT
#include "texture/own_image.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "algebra/error.h"
#include "files/own_file.h"
#include "texture/read_image.h"

namespace coppermoon::texture {
namespace {

/// Whether an image's header has an attribute of coppermoon's: a texture's settings, or a picture's display view.
bool is_ours(const std::filesystem::path& file) try {
  constexpr std::array<std::string_view, 2> names{"coppermoon:recipe", "coppermoon:view"};
  return std::ranges::any_of(read_attributes(file, names),
                             [](const auto& value) { return value.has_value(); });
} catch (const algebra::Error&) {
  return false;
}

}  // namespace

void require_own_image(const std::filesystem::path& file) {
  files::require_no_link(file);
  if (std::filesystem::exists(file) && !is_ours(file))
    throw algebra::Error(files::not_as_written(file));
}

}  // namespace coppermoon::texture
