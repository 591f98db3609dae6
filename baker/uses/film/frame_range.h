// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Frames as the trade writes them: "1-240", "1-240x2" (every second), "7,9,20-30"; each once, in the
/// order written.
///
/// Given   text   empty: all
///         count  number of the film's frames, which count from 1
/// Throws  Error  when it is none such, or goes beyond the film
std::vector<std::size_t> frames_in(const std::string& text, std::size_t count);

/// Every N-th of some frames from the K-th on.
std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, const Shard& shard);

}  // namespace coppermoon::uses
