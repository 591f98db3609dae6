// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "files/handle.h"

namespace coppermoon::texture {

/// Name of the attribute in an OpenEXR file that holds the fingerprint of the file's bytes, as 16 hexadecimal digits.
/// When the fingerprint is computed, these digits count as 0.
inline constexpr const char *seal_attribute = "coppermoon:fingerprint",
                            *unsealed = "0000000000000000";

/// Writes a file's fingerprint into its header, where it replaces the placeholder `unsealed`.
///
/// Given   file   open for reading and writing
///         path   for error messages
/// Throws  Error  when the file cannot be read or written
void seal(const files::Handle& file, const std::filesystem::path& path);

/// Whether every byte of an OpenEXR file is as it was when its fingerprint was written. The check matters for half
/// floats packed with PIZ, which have no checksum of their own.
///
/// Returned  false, too, for a file that has no fingerprint or cannot be read
bool is_sealed(const std::filesystem::path& path);

}  // namespace coppermoon::texture
