// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Refuses to overwrite an image that coppermoon did not make, or a link; absence is sound.
///
/// Throws  Error
void require_own_image(const std::filesystem::path& file);

}  // namespace coppermoon::texture
