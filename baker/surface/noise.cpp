// SPDX-License-Identifier: MIT
#include "surface/noise.h"

#include <cmath>
#include <cstddef>

namespace coppermoon::surface {
namespace {

/// The eight corner values of one cube.
struct Cube {
  std::array<std::int32_t, 3> at{INT32_MIN, 0, 0};
  std::array<Noise, 8> corners;
};

Noise corner_value(std::uint64_t hash) {
  Noise value;
  for (std::size_t i = 0; i < 4; ++i)
    value[i] = static_cast<float>((hash >> (16 * i)) & 0xFFFF) * (2.0F / 65535) - 1;
  return value;
}

void move_to(Cube& cube, const std::array<std::int32_t, 3>& at, std::uint32_t seed) {
  cube.at = at;
  for (std::int32_t i = 0; i < 8; ++i)
    cube.corners[static_cast<std::size_t>(i)] =
        corner_value(hashed(at[0] + (i & 1), at[1] + (i >> 1 & 1), at[2] + (i >> 2), seed));
}

float smooth(float t) { return t * t * (3 - 2 * t); }

Noise interpolated(const Cube& cube, const glm::vec3& t) {
  const float x = smooth(t.x), y = smooth(t.y), z = smooth(t.z);
  const auto& c = cube.corners;
  Noise value;
  for (std::size_t i = 0; i < 4; ++i) {
    const float a = c[0][i] + x * (c[1][i] - c[0][i]), b = c[2][i] + x * (c[3][i] - c[2][i]);
    const float d = c[4][i] + x * (c[5][i] - c[4][i]), e = c[6][i] + x * (c[7][i] - c[6][i]);
    const float near = a + y * (b - a), far = d + y * (e - d);
    value[i] = near + z * (far - near);
  }
  return value;
}

/// Turns the lattice away from the poles and the seam, where its planes would show.
glm::vec3 turned(const glm::vec3& v) {
  return {0.36F * v.x + 0.48F * v.y - 0.8F * v.z, -0.8F * v.x + 0.6F * v.y,
          0.48F * v.x + 0.64F * v.y + 0.6F * v.z};
}

}  // namespace

std::uint64_t hashed(std::int32_t x, std::int32_t y, std::int32_t z, std::uint32_t seed) {
  std::uint64_t h = static_cast<std::uint32_t>(x) * 0x9E3779B97F4A7C15ULL;
  h = (h ^ static_cast<std::uint32_t>(y)) * 0xBF58476D1CE4E5B9ULL;
  h = (h ^ h >> 29 ^ static_cast<std::uint32_t>(z)) * 0x94D049BB133111EBULL;
  h = (h ^ h >> 32 ^ seed) * 0xD6E8FEB86659FD93ULL;
  return h ^ h >> 32;
}

double unit_interval(std::uint64_t hash) { return static_cast<double>(hash >> 11) * 0x1p-53; }

void add_noise(std::span<const glm::vec3> points, float frequency, const Noise& amplitude,
               std::span<Noise> sums) {
  const auto seed = static_cast<std::uint32_t>(frequency * 16);
  Cube cube;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 p = turned(points[i]) * frequency;
    const glm::vec3 floor{std::floor(p.x), std::floor(p.y), std::floor(p.z)};
    const std::array at{static_cast<std::int32_t>(floor.x), static_cast<std::int32_t>(floor.y),
                        static_cast<std::int32_t>(floor.z)};
    if (at != cube.at) move_to(cube, at, seed);
    const Noise value = interpolated(cube, p - floor);
    for (std::size_t k = 0; k < 4; ++k) sums[i][k] += amplitude[k] * value[k];
  }
}

}  // namespace coppermoon::surface
