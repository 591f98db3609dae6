// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace coppermoon::surface {

/// Random words that are a function of four integers alone.
std::uint64_t hashed(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed);

/// The bits of a hash as a number, 0 to 1.
double unit_interval(std::uint64_t hash);

/// Four independent noise values, each −1 to 1.
using Noise = std::array<float, 4>;

/// Value noise in space at each of many points: random values at the corners of cubes, smoothly
/// interpolated, so a sphere cut out of it has neither seam nor pole. Neighbouring points are
/// quick.
///
/// Given     points      unit vectors
///           frequency   cubes to the unit of length
///           amplitude   what each of the four values is multiplied by before it is added
/// Returned  added to `sums`, as many as points
void add_noise(std::span<const glm::vec3> points, float frequency, const Noise& amplitude,
               std::span<Noise> sums);

}  // namespace coppermoon::surface
