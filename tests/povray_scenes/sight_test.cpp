// SPDX-License-Identifier: MIT
#include "povray_scenes/scene_camera.h"

#include <glm/geometric.hpp>

#include "support/testing.h"

namespace coppermoon::povray_scenes::sight_test {

using algebra::degrees;

constexpr const char* rounding =
    "rounding of doubles 220 radii from the Moon, over the slope of ground seen aslant";

/// Cameras of all kinds: flattened by air, aimed beside the Moon's centre.
std::vector<SceneCamera> cameras() {
  SceneCamera plain{{220, 10, -5}, {0.2, 0.3, 1}, degrees(0.7), 300, 200};
  SceneCamera flat = plain, aimed = plain;
  flat.flattening = 0.85;
  flat.zenith = {0, 1, 0.5};
  aimed.direction = -aimed.position + glm::dvec3(0, 0.3, 0.2);
  return {plain, flat, aimed, {{2, 0, 0}, {0, 0, 1}, degrees(80), 100, 100}};
}

TEST(Sight, ShowsTheGroundThatFallsOnThePixel) {
  for (const auto& camera : cameras()) {
    const auto sight = sight_of(camera);
    int seen = 0;
    for (double latitude = -80; latitude <= 80; latitude += 20)
      for (double longitude = -180; longitude < 180; longitude += 20) {
        const almanac::SelenographicPoint place{degrees(latitude), degrees(longitude)};
        const auto pixel = pixel_of(camera, place);
        const auto direction = almanac::selenographic_direction(place);
        const bool aslant = glm::dot(direction, glm::normalize(camera.position - direction)) < 0.02;
        if (!pixel || aslant) continue;
        ++seen;
        const auto ground = ground_at(sight, *pixel);
        ASSERT_TRUE(ground);
        EXPECT_WITHIN(glm::length(*ground - direction), 0, 1e-8, rounding);
      }
    EXPECT_GT(seen, 20);  // of 162, half are in sight from afar, a quarter from 2 radii
  }
}

TEST(Sight, ShowsNothingBesideTheMoon) {
  for (const auto& camera : cameras()) {
    const auto sight = sight_of(camera);
    EXPECT_FALSE(ground_at(sight, {-500, 0}));
    EXPECT_FALSE(ground_at(sight, {0, 1000}));
  }
}

}  // namespace coppermoon::povray_scenes::sight_test
