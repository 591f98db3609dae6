// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "shadow/photon_sums.h"

namespace coppermoon::uses {

/// Writes photons' sums as one JSON document, every number with all its digits; the file appears whole or not at all.
///
/// Throws  Error  one line with the path, when it cannot
void write_sums(const std::filesystem::path& path, const shadow::PhotonSums& sums);

/// Reads sums of photons, bit by bit as they were written.
///
/// Throws  Error  "<path>: …" when it cannot be read, is of another kind or version, or holds what sums cannot: lists
///                of the wrong length, numbers that are negative or not finite, blocks out of order
shadow::PhotonSums read_sums(const std::filesystem::path& path);

}  // namespace coppermoon::uses
