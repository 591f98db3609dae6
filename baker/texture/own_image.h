// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::texture {

/// Refuses an image that coppermoon did not make, or a link: it would be overwritten. None at all may
/// be there.
///
/// Throws  Error
void require_own_image(const std::filesystem::path& file);

}  // namespace coppermoon::texture
