// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace coppermoon::surface {

/// Random words that are a function of four integers alone.
std::uint64_t hashed(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed);

/// The bits of a hash as a number, 0 to 1.
double unit_interval(std::uint64_t hash);

/// Unit vectors, coordinate by coordinate.
struct Directions {
  std::span<const float> x, y, z;
};

/// Four independent noise values of each of many points, each −1 to 1, value by value.
using Noise = std::array<std::span<float>, 4>;

/// Value noise in space at each of many points: random values at the corners of cubes, smoothly
/// interpolated, so a sphere cut out of it has neither seam nor pole. Neighbouring points are
/// quick.
///
/// Given     frequency   cubes to the unit of length
///           amplitude   what each of the four values is multiplied by before it is added
/// Returned  added to `sums`, as many as points
void add_noise(const Directions& points, float frequency, const std::array<float, 4>& amplitude,
               const Noise& sums);

}  // namespace coppermoon::surface
