// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace coppermoon::algebra {

/// Philox 4x32-10: four random words that are a function of the counter and the key alone.
///
/// Source  Salmon, Moraes, Dror & Shaw (2011), Parallel random numbers: as easy as 1, 2, 3, SC11
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// Random numbers for one photon. `seed` and `index` alone determine the stream, regardless of the thread.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t index) : seed_(seed), index_(index) {}

  /// Uniform in [0, 1), with 53 random bits.
  double uniform();

 private:
  std::uint64_t seed_, index_;
  std::uint32_t block_ = 0;
  std::size_t left_ = 0;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace coppermoon::algebra
