// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Refuses to overwrite a link, or an image that coppermoon did not make. It is fine if the file does not exist.
///
/// Throws  Error
void require_own_image(const std::filesystem::path& file);

}  // namespace coppermoon::texture
