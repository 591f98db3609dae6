// SPDX-License-Identifier: MIT
#include "algebra/low_discrepancy.h"

#include <array>
#include <bit>

#include "algebra/error.h"
#include "algebra/random.h"

namespace coppermoon::algebra {
namespace {

constexpr std::size_t digits = std::bit_width(points_a_block) - 1;

using Directions = std::array<std::uint32_t, digits>;  // one number per binary digit of an index

/// Primitive polynomial over the binary field, given by its degree and its inner coefficients, with the initial numbers
/// of the recurrence that it defines.
struct Polynomial {
  std::size_t degree;
  std::uint32_t inner;
  std::array<std::uint32_t, 3> first;
};

constexpr std::array<Polynomial, 4> polynomials{
    {{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}, {3, 2, {1, 1, 1}}}};

constexpr Directions directions_of(const Polynomial& p) {
  std::array<std::uint32_t, digits> m{};
  for (std::size_t k = 0; k < digits; ++k) {
    if (k < p.degree) {
      m[k] = p.first[k];
      continue;
    }
    m[k] = m[k - p.degree] ^ m[k - p.degree] << p.degree;
    for (std::size_t j = 1; j < p.degree; ++j)
      if (p.inner >> (p.degree - 1 - j) & 1) m[k] ^= m[k - j] << j;
  }
  for (std::size_t k = 0; k < digits; ++k) m[k] <<= digits - 1 - k;
  return m;
}

constexpr Directions reversal() {
  Directions v{};
  for (std::size_t k = 0; k < digits; ++k) v[k] = 1U << (digits - 1 - k);
  return v;
}

/// Direction numbers of Sobol's sequence for dimension 1 and up; dimension 0 needs none.
constexpr std::array<Directions, most_dimensions - 1> directions{
    reversal(), directions_of(polynomials[0]), directions_of(polynomials[1]),
    directions_of(polynomials[2]), directions_of(polynomials[3])};

std::uint32_t sobol(const Directions& v, std::size_t point) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < digits; ++k)
    if (point >> k & 1) value ^= v[k];
  return value;
}

/// Source of random bits. Each uniform random number supplies 32 bits.
class Bits {
 public:
  explicit Bits(Random& random) : random_(random) {}

  std::uint32_t next() {
    if (left_ == 0) word_ = static_cast<std::uint32_t>(random_.uniform() * 0x1p32), left_ = 32;
    return word_ >> --left_ & 1;
  }

 private:
  Random& random_;
  std::uint32_t word_ = 0;
  int left_ = 0;
};

/// Random permutation of 1024 equal intervals: swaps the halves or not, then the quarters in each half, and so on.
std::array<std::uint32_t, points_a_block> scrambling(Random& random) {
  std::array<std::uint32_t, points_a_block> place{}, finer{};
  Bits bits(random);
  for (std::size_t parts = 1; parts < points_a_block; parts *= 2) {
    for (std::size_t i = 0; i < parts; ++i) {
      const std::uint32_t flip = bits.next();
      finer[2 * i] = 2 * place[i] + flip;
      finer[2 * i + 1] = 2 * place[i] + 1 - flip;
    }
    place = finer;
  }
  return place;
}

}  // namespace

Grid<double> scrambled_block(std::uint64_t seed, std::uint64_t block, std::size_t dimensions) {
  require_within("dimensions", static_cast<double>(dimensions), 1, most_dimensions);
  Random random(seed, block);
  Grid<double> points(points_a_block, dimensions);
  for (std::size_t i = 0; i < points_a_block; ++i)
    points(i, 0) = (static_cast<double>(i) + random.uniform()) / points_a_block;
  for (std::size_t d = 1; d < dimensions; ++d) {
    const auto place = scrambling(random);
    for (std::size_t i = 0; i < points_a_block; ++i)
      points(i, d) = (place[sobol(directions[d - 1], i)] + random.uniform()) / points_a_block;
  }
  return points;
}

}  // namespace coppermoon::algebra
