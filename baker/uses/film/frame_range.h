// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Frames of a range in the notation of render farms: "1-240", "1-240x2" (every second), "7,9,20-30". Each stands
/// once, in the order written.
///
/// Given   text   empty: all
///         count  number of the film's frames
///         first  number of the first
/// Throws  Error  for another notation; for a frame beyond the film
std::vector<std::size_t> frames_in(const std::string& text, std::size_t count,
                                   std::size_t first = 1);

/// Share of shard K/N: every N-th frame from the K-th on.
std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, const Shard& shard);

}  // namespace coppermoon::uses
