// SPDX-License-Identifier: MIT
#include "povray_scenes/mitsuba.h"

#include <glm/geometric.hpp>

#include "povray_scenes/folder.h"
#include "povray_scenes/meridian.h"
#include "support/testing.h"

namespace coppermoon::povray_scenes::mitsuba_test {

MoonScene plain_scene() {
  return {.camera = {{221.25, -3.5, 7.125}, {0, 0.25, 1}, algebra::degrees(0.625), 640, 480},
          .texture = "moon.0001.exr"};
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

/// Corners and facets of a mesh, as an OBJ file has them.
struct Mesh {
  std::vector<glm::dvec3> points{};
  std::vector<glm::dvec2> places{};
  std::vector<std::array<std::size_t, 3>> facets{};
};

Mesh read(const std::string& text) {
  Mesh mesh;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      glm::dvec3 v;
      words >> v.x >> v.y >> v.z;
      mesh.points.push_back(v);
    } else if (kind == "vt") {
      glm::dvec2 st;
      words >> st.x >> st.y;
      mesh.places.push_back(st);
    } else if (kind == "f") {
      std::array<std::size_t, 3> facet{};
      for (auto& corner : facet) {
        std::string pair;
        words >> pair;
        const auto slash = pair.find('/');
        EXPECT_EQ(pair.substr(0, slash), pair.substr(slash + 1));
        corner = std::stoul(pair) - 1;
      }
      mesh.facets.push_back(facet);
    }
  }
  return mesh;
}

/// Longitude from 180° W eastwards as 0 to 1, latitude from the south pole as 0 to 1: the direction is the closed form.
glm::dvec3 direction(const glm::dvec2& st) {
  const double longitude = algebra::in_radians(algebra::degrees(360 * st.x - 180)),
               latitude = algebra::in_radians(algebra::degrees(180 * st.y - 90));
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

/// All facets face away from the Moon's centre, where its light goes.
void expect_lit_from_outside(const Mesh& mesh) {
  for (const auto& [a, b, c] : mesh.facets) {
    const auto &p = mesh.points[a], &q = mesh.points[b], &r = mesh.points[c];
    ASSERT_GT(glm::dot(glm::cross(q - p, r - p), p + q + r), 0);
  }
}

TEST(MitsubaMesh, HasEachTexelAtItsPlace) {
  const auto mesh = read(mitsuba_mesh(plain_scene()));
  ASSERT_EQ(mesh.points.size(), mesh.places.size());
  ASSERT_GT(mesh.facets.size(), 60000u);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
    EXPECT_WITHIN(glm::length(mesh.points[i] - direction(mesh.places[i])), 0, 1e-8,
                  "nine digits of numbers up to 1");
  expect_lit_from_outside(mesh);
}

TEST(MitsubaMesh, IsFlattenedTowardsTheZenith) {
  auto scene = plain_scene();
  scene.camera.position = {200, 0, 0};
  scene.camera.zenith = {0, 0, 1};
  scene.camera.flattening = 0.85;
  for (const auto& p : read(mitsuba_mesh(scene)).points)
    EXPECT_WITHIN(p.x * p.x + p.y * p.y + p.z * p.z / (0.85 * 0.85), 1, 1e-7,
                  "an ellipsoid, in nine digits");
}

TEST(ToMitsuba, LooksFromTheCameraInTheMoonFixedFrame) {
  const auto text = to_mitsuba(plain_scene());
  EXPECT_TRUE(says(text, "origin=\"221.25, -3.5, 7.125\" target=\"0, 0, 0\""));
  EXPECT_TRUE(says(text, R"(<string name="fov_axis" value="x"/>)"));
  EXPECT_TRUE(says(text, R"(<float name="fov" value="0.625"/>)"));
  EXPECT_TRUE(says(text, R"(<integer name="width" value="640"/>)"));
  EXPECT_TRUE(says(text, R"(<string name="filename" value="moon.0001.exr"/>)"));
}

TEST(ToMitsuba, HasALightOfAStarsIlluminance) {
  auto scene = plain_scene();
  scene.lights = {{glm::normalize(glm::dvec3(-1, 0.002, 0)), {2e-6, 1e-6, 5e-7}}};
  const auto text = to_mitsuba(scene);
  const auto number_after = [&](const std::string& words) {
    return std::stod(text.substr(text.find(words) + words.size()));
  };
  const double radius = number_after("name=\"radius\" value=\""),
               red = number_after("name=\"radiance\" value=\""),
               away = 2 * glm::length(scene.camera.position);
  EXPECT_WITHIN_RELATIVE(red * std::numbers::pi * radius * radius / (away * away), 2e-6, 1e-5,
                         "six digits are written");
}

TEST(ToMitsuba, RefusesWhatPovRayIsRefused) {
  auto scene = plain_scene();
  scene.texture = "moon.png";
  EXPECT_THROW(to_mitsuba(scene), algebra::Error);
  scene = plain_scene();
  scene.camera.width = 0;
  EXPECT_THROW(mitsuba_mesh(scene), algebra::Error);
}

TEST(WriteMitsubaScene, IsWrittenAgainUnlessSomebodyChangedIt) {
  const TemporaryFolder folder;
  write_mitsuba_scene(folder.path, plain_scene());
  EXPECT_NO_THROW(require_mitsuba_place(folder.path));
  std::ofstream(folder.path / mitsuba_file, std::ios::app) << "<!-- mine -->\n";
  EXPECT_THROW(require_mitsuba_place(folder.path), algebra::Error);
}

}  // namespace coppermoon::povray_scenes::mitsuba_test
