// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace coppermoon::algebra {

/// Random generator Philox 4x32-10. Its four random words depend only on the counter and the key.
///
/// Source  Salmon, Moraes, Dror & Shaw (2011), Parallel random numbers: as easy as 1, 2, 3, SC11
std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key);

/// Sequence of random numbers for one photon. It depends only on `seed` and `index`, not on the thread.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t index) : seed_(seed), index_(index) {}

  /// Next random number, uniform in [0, 1), with 53 random bits.
  double uniform();

 private:
  std::uint64_t seed_, index_;
  std::uint32_t block_ = 0;
  std::size_t left_ = 0;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace coppermoon::algebra
