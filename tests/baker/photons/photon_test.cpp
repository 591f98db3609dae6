// SPDX-License-Identifier: MIT
#include "photons/photon.h"

#include <glm/geometric.hpp>

#include "baker/algebra/chi_squared.h"
#include "photons/solar_disc.h"
#include "support/testing.h"

namespace coppermoon::photons::photon_test {

constexpr double sun_distance_m = 149597870700;

const atmosphere::Atmosphere air;

constexpr std::size_t bin_of(double uniform, int bins) {
  return static_cast<std::size_t>(std::clamp(uniform * bins, 0.0, bins - 0.5));
}

Ray photon(std::uint64_t i) {
  algebra::Random random(7, i);
  return aimed_at_the_ring(random, sun_distance_m, air);
}

/// The point of a ray that is nearest to the Earth's centre.
glm::dvec3 nearest(const Ray& ray) {
  return ray.position_m - glm::dot(ray.position_m, ray.direction) * ray.direction;
}

/// Where b² lies between the ground's and the top's, 0 to 1.
double ring_place(const Ray& ray) {
  const double b = glm::length(nearest(ray)), inner = air.earth.equatorial_radius_m,
               outer = air.top_radius_m();
  return (b * b - inner * inner) / (outer * outer - inner * inner);
}

double turn(double x, double y) { return std::atan2(y, x) / (2 * std::numbers::pi) + 0.5; }

TEST(AimedAtTheRing, FillsTheRingEvenlyInAreaAndAzimuth) {
  std::array<int, 256> seen{};
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const Ray ray = photon(i);
    const double place = ring_place(ray);
    ASSERT_TRUE(place > -1e-9 && place < 1 + 1e-9) << place;
    ++seen[16 * bin_of(place, 16) + bin_of(turn(nearest(ray).x, nearest(ray).y), 16)];
  }
  EXPECT_UNIFORM(seen, chi_squared_of_255);
}

TEST(AimedAtTheRing, LeavesTheSolarDiscEvenly) {
  std::array<int, 100> seen{};
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const auto from = photon(i).position_m;
    ASSERT_EQ(from.z, -sun_distance_m);
    const double r = std::hypot(from.x, from.y) / solar_radius_m;
    ASSERT_LE(r, 1);
    ++seen[10 * bin_of(r * r, 10) + bin_of(turn(from.x, from.y), 10)];
  }
  EXPECT_UNIFORM(seen, chi_squared_of_99);
}

TEST(AimedAtTheRing, AimsWhateverThePlaceOnTheDisc) {
  std::array<int, 100> seen{};
  for (std::uint64_t i = 0; i < 200'000; ++i) {
    const Ray ray = photon(i);
    ++seen[10 * bin_of(turn(ray.position_m.x, ray.position_m.y), 10) +
           bin_of(turn(nearest(ray).x, nearest(ray).y), 10)];
  }
  EXPECT_UNIFORM(seen, chi_squared_of_99);
}

TEST(AimedAtTheRing, GivesUnitDirectionsAwayFromTheSun) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    EXPECT_WITHIN(glm::length(photon(i).direction), 1.0, 1e-15, "rounding");
    EXPECT_GT(photon(i).direction.z, 0.9999);
  }
}

TEST(AimedAtTheRing, TakesFourNumbers) {
  algebra::Random used(1, 2), counted(1, 2);
  aimed_at_the_ring(used, sun_distance_m, air);
  for (int i = 0; i < 4; ++i) counted.uniform();
  EXPECT_EQ(used.uniform(), counted.uniform());
}

TEST(AtDepth, IsWhereTheLineCrossesThePlane) {
  const Ray ray{{1, 2, -10}, glm::normalize(glm::dvec3(1, -1, 2))};
  const auto place = at_depth(ray, 4);
  EXPECT_WITHIN(place.x, 8.0, 1e-14, "rounding");
  EXPECT_WITHIN(place.y, -5.0, 1e-14, "rounding");
  EXPECT_WITHIN(place.z, 4.0, 1e-14, "rounding");
}

}  // namespace coppermoon::photons::photon_test
