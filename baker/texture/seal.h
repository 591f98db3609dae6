// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "files/handle.h"

namespace coppermoon::texture {

/// The attribute of an OpenEXR file that holds the fingerprint of its bytes, as 16 hexadecimal digits;
/// each digit counts as 0 in it.
inline constexpr const char *seal_attribute = "coppermoon:fingerprint",
                            *unsealed = "0000000000000000";

/// Puts the fingerprint of a whole file into its header, where `unsealed` stands.
///
/// Given   file   open for reading and writing
///         path   for the error's text
/// Throws  Error  when it cannot be read or written
void seal(const files::Handle& file, const std::filesystem::path& path);

/// Whether an OpenEXR file is, byte by byte, as it was sealed: half floats packed by PIZ have no
/// check of their own.
///
/// Returned  false for a file without a seal, and for one that cannot be read
bool is_sealed(const std::filesystem::path& path);

}  // namespace coppermoon::texture
