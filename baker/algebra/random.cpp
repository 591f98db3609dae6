// SPDX-License-Identifier: MIT
#include "algebra/random.h"

namespace coppermoon::algebra {
namespace {

constexpr std::uint32_t low(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
constexpr std::uint32_t high(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> c,
                                    std::array<std::uint32_t, 2> key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0];
    const std::uint64_t b = std::uint64_t{0xCD9E8D57} * c[2];
    c = {high(b) ^ c[1] ^ key[0], low(b), high(a) ^ c[3] ^ key[1], low(a)};
    key = {key[0] + 0x9E3779B9u, key[1] + 0xBB67AE85u};
  }
  return c;
}

double Random::uniform() {
  if (left_ == 0) {
    words_ = philox({block_++, 0, low(index_), high(index_)}, {low(seed_), high(seed_)});
    left_ = 2;
  }
  --left_;
  const std::uint64_t bits = (std::uint64_t{words_[2 * left_]} << 32 | words_[2 * left_ + 1]) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

}  // namespace coppermoon::algebra
