// SPDX-License-Identifier: MIT
#include "photons/photon.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "photons/solar_disc.h"

namespace coppermoon::photons {

Ray aimed_at_the_ring(algebra::Random& random, double sun_distance_m,
                      const atmosphere::Atmosphere& atmosphere) {
  const auto place = random_place_on_disc(random) * solar_radius_m;
  const glm::dvec3 source(place.x, place.y, -sun_distance_m);
  const double inner = innermost_radius_m(atmosphere), outer = atmosphere.top_radius_m();
  const double b = std::sqrt(inner * inner + random.uniform() * (outer * outer - inner * inner));
  const double azimuth = 2 * std::numbers::pi * random.uniform();

  const double distance = glm::length(source);
  const glm::dvec3 to_earth = -source / distance;
  const glm::dvec3 across = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), to_earth));
  const glm::dvec3 upward = glm::cross(to_earth, across);
  const double sine = b / distance, cosine = std::sqrt(1 - sine * sine);
  return {
      source,
      // FAULT a ring of photons 1 % narrow one way: std::cos(azimuth) => 0.99 * std::cos(azimuth)
      cosine * to_earth + sine * (std::cos(azimuth) * across + std::sin(azimuth) * upward)};
}

double innermost_radius_m(const atmosphere::Atmosphere& atmosphere) {
  return std::min(atmosphere.earth.polar_radius_m, atmosphere.earth.equatorial_radius_m);
}

glm::dvec3 at_depth(const Ray& ray, double depth_m) {
  return ray.position_m + (depth_m - ray.position_m.z) / ray.direction.z * ray.direction;
}

}  // namespace coppermoon::photons
