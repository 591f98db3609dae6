// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "files/handle.h"

namespace coppermoon::texture {

/// The attribute in an OpenEXR file that holds the fingerprint of the file's bytes, as 16 hexadecimal digits.
/// For the fingerprint, these digits themselves count as 0.
inline constexpr const char *seal_attribute = "coppermoon:fingerprint",
                            *unsealed = "0000000000000000";

/// Writes a file's fingerprint into its header, in place of `unsealed`.
///
/// Given   file   open for reading and writing
///         path   for the error's text
/// Throws  Error  when the file cannot be read or written
void seal(const files::Handle& file, const std::filesystem::path& path);

/// Whether every byte of an OpenEXR file is as it was when sealed. Half floats packed by PIZ have no
/// checksum of their own.
///
/// Returned  false for a file without a seal, and for one that cannot be read
bool is_sealed(const std::filesystem::path& path);

}  // namespace coppermoon::texture
