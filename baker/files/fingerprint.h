// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace coppermoon::files {

/// A 64-bit checksum that tells contents apart but does not protect against forgery. It is the same on every machine.
///
/// Source  XXH3_64bits of xxHash 0.8
std::uint64_t fingerprint(std::string_view bytes);

/// The checksum that `fingerprint` returns, for bytes that arrive in pieces.
///
/// Given  next  called repeatedly; returns the next piece, or an empty text after the last piece
std::uint64_t fingerprint_of_pieces(const std::function<std::string()>& next);

}  // namespace coppermoon::files
