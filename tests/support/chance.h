// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace coppermoon::support {

/// Whether the i-th of all is of the part that this run draws, one of `parts`: COPPERMOON_TURN says which. All are
/// without it.
inline bool is_drawn(std::uint64_t i, std::uint64_t parts) {
  const char* turn = std::getenv("COPPERMOON_TURN");
  return turn == nullptr || i % parts == std::strtoull(turn, nullptr, 10) % parts;
}

/// How many of some trials come true.
struct Counts {
  int least, most;
};

/// Counts that so many trials of one chance stay within, but for one test in a thousand below and one above.
inline Counts counts_of(int trials, double chance) {
  const auto probability = [&](int k) {
    return std::exp(std::lgamma(trials + 1.) - std::lgamma(k + 1.) - std::lgamma(trials - k + 1.) +
                    k * std::log(chance) + (trials - k) * std::log1p(-chance));
  };
  Counts counts{0, trials};
  for (double below = probability(0); below < 1e-3; below += probability(++counts.least)) {
  }
  for (double above = probability(trials); above < 1e-3; above += probability(--counts.most)) {
  }
  return counts;
}

/// Of all, what is asked of them; of a part, counts_of.
inline Counts asked(Counts of_all, int all, int trials, double chance) {
  return trials == all ? of_all : counts_of(trials, chance);
}

}  // namespace coppermoon::support
