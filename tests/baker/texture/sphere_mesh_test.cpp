// SPDX-License-Identifier: MIT
#include "texture/sphere_mesh.h"

#include <glm/geometric.hpp>

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace sphere_mesh_test {

using namespace coppermoon::texture;
using std::numbers::pi;

/// Six times the volume between a facet and the centre; positive where it is counter-clockwise from
/// outside.
double six_volumes(const SphereMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto [a, b, c] = triangle;
  return glm::dot(mesh.points[a], glm::cross(mesh.points[b], mesh.points[c]));
}

glm::dvec3 twice_the_area(const SphereMesh& mesh, const std::array<std::uint32_t, 3>& triangle) {
  const auto& a = mesh.points[triangle[0]];
  return glm::cross(mesh.points[triangle[1]] - a, mesh.points[triangle[2]] - a);
}

TEST(SphereMesh, HasTheAreaAndVolumeOfTheSphere) {
  for (const std::size_t rows : {std::size_t{16}, sphere_rows}) {
    const auto mesh = sphere_mesh(rows);
    double area = 0, volume = 0;
    for (const auto& triangle : mesh.triangles) {
      area += glm::length(twice_the_area(mesh, triangle)) / 2;
      volume += six_volumes(mesh, triangle) / 6;
    }
    const double angle = pi / static_cast<double>(rows);
    EXPECT_WITHIN_RELATIVE(
        volume, 4 * pi / 3, angle * angle,
        "chords of angle π/rows lie up to angle²/8 below, twice over, three times in volume");
    EXPECT_WITHIN_RELATIVE(area, 4 * pi, angle * angle, "the same");
    EXPECT_LT(volume, 4 * pi / 3);
    EXPECT_LT(area, 4 * pi);
  }
}

TEST(SphereMesh, PointsAreOnTheSphere) {
  for (const auto& point : sphere_mesh().points)
    EXPECT_WITHIN(glm::length(point), 1., 1e-15, "rounding");
}

TEST(SphereMesh, EveryFacetTurnsCounterClockwiseOutwards) {
  const auto mesh = sphere_mesh();
  for (const auto& triangle : mesh.triangles)
    ASSERT_GT(glm::dot(twice_the_area(mesh, triangle), mesh.points[triangle[0]]), 0);
}

TEST(SphereMesh, IsClosed) {
  const auto mesh = sphere_mesh(8);
  using Key = std::array<long, 3>;
  const auto key = [&](std::uint32_t i) {
    const auto& p = mesh.points[i];
    return Key{std::lround(p.x * 1e9), std::lround(p.y * 1e9), std::lround(p.z * 1e9)};
  };
  std::map<std::pair<Key, Key>, int> sides;
  for (const auto& [a, b, c] : mesh.triangles)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      ++sides[{key(from), key(to)}];
  for (const auto& [side, count] : sides) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(sides.contains({side.second, side.first}));
  }
}

/// The point that carries a place of the texture.
glm::dvec3 point_at(const SphereMesh& mesh, double s, double t) {
  const auto there = std::ranges::find_if(mesh.st, [&](const glm::dvec2& st) {
    return std::abs(st.x - s) < 1e-9 && std::abs(st.y - t) < 1e-9;
  });
  EXPECT_NE(there, mesh.st.end());
  return mesh.points[static_cast<std::size_t>(there - mesh.st.begin())];
}

void expect_near(const glm::dvec3& point, const glm::dvec3& wanted) {
  EXPECT_WITHIN(glm::distance(point, wanted), 0., 1e-15, "rounding of sines");
}

TEST(SphereMesh, TheNearSideLooksAlongZWithEastToTheRightAndNorthUp) {
  const auto mesh = sphere_mesh();
  expect_near(point_at(mesh, 0.5, 0.5), {0, 0, 1});
  expect_near(point_at(mesh, 0.75, 0.5), {1, 0, 0});
  expect_near(point_at(mesh, 0.25, 0.5), {-1, 0, 0});
  expect_near(point_at(mesh, 0.5, 0.75), {0, std::sqrt(0.5), std::sqrt(0.5)});
  const auto right = glm::cross(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1));
  expect_near(right, point_at(mesh, 0.75, 0.5));  // up × towards the viewer
}

TEST(SphereMesh, BothSidesOfTheSeamAreTheSamePoints) {
  const auto mesh = sphere_mesh();
  for (std::size_t row = 1; row < sphere_rows; ++row) {
    const double t = 1 - static_cast<double>(row) / static_cast<double>(sphere_rows);
    EXPECT_EQ(point_at(mesh, 0, t), point_at(mesh, 1, t));
  }
}

TEST(SphereMesh, NoFacetReachesOverMoreOfTheTextureThanItsColumn) {
  const auto mesh = sphere_mesh();
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto [west, east] = std::minmax({mesh.st[a].x, mesh.st[b].x, mesh.st[c].x});
    ASSERT_LT(east - west, 1.0001 / (2 * sphere_rows));
  }
}

TEST(SphereMesh, RefusesFewerRowsThanTwo) {
  EXPECT_ERROR(sphere_mesh(1), "rows of the sphere's facets = 1, allowed 2 to 4096");
  EXPECT_EQ(sphere_mesh(2).triangles.size(), 8U);
}

}  // namespace sphere_mesh_test
