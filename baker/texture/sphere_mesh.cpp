// SPDX-License-Identifier: MIT
#include "texture/sphere_mesh.h"

#include <cmath>
#include <numbers>

#include "algebra/error.h"

namespace coppermoon::texture {
namespace {

using std::numbers::pi;

/// Direction of a point on the sphere from its colatitude `down` and its longitude `along` (from −180° to 180°), both
/// scaled to 0 to 1. The two sides of the seam coincide.
glm::dvec3 direction(double down, double along) {
  const double sine = std::sin(pi * down), turn = 2 * pi * (along < 1 ? along : 0);
  return {-sine * std::sin(turn), std::cos(pi * down), -sine * std::cos(turn)};
}

/// A sphere mesh under construction, row by row from the north.
struct Making {
  std::size_t rows, columns = 2 * rows;
  SphereMesh mesh{};

  static double part(double i, std::size_t all) { return i / static_cast<double>(all); }

  void add_pole(double down) {
    for (std::size_t c = 0; c < columns; ++c) {
      mesh.points.push_back({0, down == 0 ? 1 : -1, 0});
      mesh.st.push_back({part(static_cast<double>(c) + 0.5, columns), 1 - down});
    }
  }

  void add_parallel(std::size_t row) {
    const double down = part(static_cast<double>(row), rows);
    for (std::size_t c = 0; c <= columns; ++c) {
      const double along = part(static_cast<double>(c), columns);
      mesh.points.push_back(direction(down, along));
      mesh.st.push_back({along, 1 - down});
    }
  }

  /// Adds the triangles between the poles and the parallels next to them, and those between neighbouring parallels.
  void add_facets() {
    const auto a_row = static_cast<std::uint32_t>(columns) + 1, first = a_row - 1;
    for (std::uint32_t c = 0; c < first; ++c)
      mesh.triangles.push_back({c, first + c, first + c + 1});
    for (std::uint32_t row = 0; row + 2 < rows; ++row)
      for (std::uint32_t c = 0; c < first; ++c) {
        const std::uint32_t north = first + row * a_row + c, south = north + a_row;
        mesh.triangles.push_back({north, south, south + 1});
        mesh.triangles.push_back({north, south + 1, north + 1});
      }
    const auto last = first + (static_cast<std::uint32_t>(rows) - 2) * a_row;
    for (std::uint32_t c = 0; c < first; ++c)
      mesh.triangles.push_back({last + c, last + a_row + c, last + c + 1});
  }
};

}  // namespace

SphereMesh sphere_mesh(std::size_t rows) {
  algebra::require_within("rows of the sphere's facets", static_cast<double>(rows), 2, 4096);
  Making making{rows};
  making.add_pole(0);
  for (std::size_t row = 1; row < rows; ++row) making.add_parallel(row);
  making.add_pole(1);
  making.add_facets();
  return making.mesh;
}

}  // namespace coppermoon::texture
