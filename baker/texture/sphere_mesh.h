// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace coppermoon::texture {

/// A sphere of radius 1 for a plate carrée texture. As in glTF and in USD with Y up, north is +Y, longitude 0 is +Z and
/// 90° E is +X. The mesh's x, y, z are therefore y, z, x in the Moon-fixed frame.
struct SphereMesh {
  std::vector<glm::dvec3> points;  ///< on the unit sphere, so each is its own normal
  /// Texture coordinates, 0 to 1: s from 180° W eastwards, t from the south pole northwards. Points on the seam appear
  /// twice, and a pole appears once for each facet that meets there.
  std::vector<glm::dvec2> st;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise as seen from outside
};

/// With 128 rows, the limb's 256 chords are off a circle by 7.5e-5 of its radius: 1/4 pixel in a disc 6600 pixels wide.
inline constexpr std::size_t sphere_rows = 128;

/// Given   rows   number of facets from pole to pole, 2 to 4096; there are twice as many around the equator
/// Throws  Error  when `rows` is out of range
SphereMesh sphere_mesh(std::size_t rows = sphere_rows);

}  // namespace coppermoon::texture
