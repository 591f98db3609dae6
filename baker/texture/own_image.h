// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Refuses to overwrite a link, or an image that coppermoon did not make. A path where no file exists is accepted.
///
/// Throws  Error
void require_own_image(const std::filesystem::path& file);

}  // namespace coppermoon::texture
