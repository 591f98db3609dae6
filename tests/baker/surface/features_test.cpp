// SPDX-License-Identifier: MIT
#include "surface/features.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "algebra/error.h"
#include "support/within.h"

namespace {

using namespace coppermoon;
using surface::features;

const std::string header =
    "name,kind,latitude,longitude,across_east,across_north,turn,normal_albedo,rays\n";

std::string error_of(const std::string& lines) {
  try {
    features(header + lines, "table");
  } catch (const algebra::Error& error) {
    return error.what();
  }
  return {};
}

TEST(Features, ReadsPatchesAndCraters) {
  const auto found = features(
      header + "A,mare,0,90,1737.4,868.7,0,0.08,0\nB,crater,-90,0,86,86,0,0.2,1000\n", "t");
  ASSERT_EQ(found.patches.size(), 1);
  const auto& patch = found.patches[0];
  EXPECT_WITHIN(patch.semi_east_rad, 0.5, 1e-6, "half of one lunar radius of 1737.4 km");
  EXPECT_WITHIN(patch.semi_north_rad, 0.25, 1e-6, "a quarter");
  EXPECT_WITHIN(glm::length(patch.at.up - glm::vec3(0, 1, 0)), 0, 1e-6, "longitude 90 is +Y");
  EXPECT_WITHIN(glm::length(patch.at.north - glm::vec3(0, 0, 1)), 0, 1e-6, "north is +Z");
  ASSERT_EQ(found.ray_craters.size(), 1);
  for (const auto& ray : found.ray_craters[0].rays)
    EXPECT_LE(ray.length_rad, 1000 / 1737.4 + 1e-6) << "none is longer than the table says";
  EXPECT_GT(found.ray_craters[0].rays.size(), 5);
}

TEST(Features, AxesOfASiteAreRightHanded) {
  const auto s = surface::site(0.7, -2.1);
  EXPECT_WITHIN(glm::length(glm::cross(s.east, s.north) - s.up), 0, 1e-6, "floats' rounding");
}

TEST(Features, OldCratersAreSpreadEvenly) {
  const auto found = features(header, "t");
  glm::dvec3 sum(0);
  for (const auto& crater : found.old_craters) sum += glm::dvec3(crater.at.up);
  const auto n = static_cast<double>(found.old_craters.size());
  EXPECT_WITHIN(glm::length(sum) / n, 0, 4 / std::sqrt(n), "four standard errors, all directions");
}

TEST(Features, NamesTheRowThatIsWrong) {
  const std::string good = "A,mare,0,90,100,100,0,0.08,0\n";
  EXPECT_EQ(error_of(good), "");
  EXPECT_EQ(error_of(good + "B,sea,0,90,1,1,0,0.1,0\n"),
            "table:row 2: kind \"sea\", allowed ground, mare, island, crater");
  EXPECT_EQ(error_of("B,mare,north,90,1,1,0,0.1,0\n"), "table:row 1: \"north\" is no number");
  EXPECT_EQ(error_of("B,mare,0\n"), "table:row 1: 3 cells, allowed 9");
}

}  // namespace
