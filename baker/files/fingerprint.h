// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace coppermoon::files {

/// Checksum of 64 bits that tells contents apart, but does not protect against forgery. Equal on every machine.
///
/// Source  XXH3_64bits of xxHash 0.8
std::uint64_t fingerprint(std::string_view bytes);

/// The same checksum for bytes that arrive in pieces.
///
/// Given  next  returns each piece in turn, and an empty one after the last
std::uint64_t fingerprint_of_pieces(const std::function<std::string()>& next);

}  // namespace coppermoon::files
