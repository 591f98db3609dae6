// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace coppermoon::verbs {

/// Frames as the trade writes them: "1-240", "1-240x2" (every second), "7,9,20-30"; each once, in the
/// order written.
///
/// Given   text   empty: all
///         count  of the film's frames, numbered from 1
/// Throws  Error  when it is none such, or goes beyond the film
std::vector<std::size_t> frames_in(const std::string& text, std::size_t count);

/// One of some parts of work, "K/N": K from 1 to N.
struct Shard {
  std::size_t part = 1, parts = 1;
};

/// Throws  Error  when the text is no such part, N at most 100000
Shard shard_from(const std::string& text);

/// Every N-th of them from the K-th on.
std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, Shard shard);

}  // namespace coppermoon::verbs
