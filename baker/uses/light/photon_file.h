// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "shadow/photon_sums.h"

namespace coppermoon::uses {

/// Writes sums of photons as one JSON document, with every digit of every number. The file appears whole or not at all.
///
/// Throws  Error  when the file cannot be written; the message is one line with the path
void write_sums(const std::filesystem::path& path, const shadow::PhotonSums& sums);

/// Reads sums of photons exactly as they were written, bit for bit.
///
/// Throws  Error  "<path>: …" when the file cannot be read, is of another kind or version, or holds invalid sums: lists
///                of the wrong length, numbers that are negative or not finite, blocks out of order
shadow::PhotonSums read_sums(const std::filesystem::path& path);

}  // namespace coppermoon::uses
