// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace coppermoon::files {

/// Checksum of 64 bits that distinguishes contents, but is no protection against forgery; equal on every machine.
///
/// Source  XXH3_64bits of xxHash 0.8
std::uint64_t fingerprint(std::string_view bytes);

}  // namespace coppermoon::files
