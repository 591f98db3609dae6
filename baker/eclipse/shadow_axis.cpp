// SPDX-License-Identifier: MIT
#include "eclipse/shadow_axis.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace coppermoon::eclipse {

ShadowAxis shadow_axis(const almanac::SkyState& sky) {
  return shadow_axis(sky.sun_m, glm::transpose(sky.equator_from_gcrs)[2]);
}

ShadowAxis shadow_axis(const glm::dvec3& sun_m, const glm::dvec3& celestial_pole) {
  const double sun_distance_m = glm::length(sun_m);
  const glm::dvec3 away = -sun_m / sun_distance_m;
  const glm::dvec3 east = glm::normalize(glm::cross(celestial_pole, away));
  const glm::dvec3 north = glm::cross(away, east);
  return {glm::transpose(glm::dmat3(east, north, away)), algebra::metres(sun_distance_m),
          algebra::radians(-std::asin(glm::dot(celestial_pole, away)))};
}

ShadowPlace place_in_shadow(const ShadowAxis& axis, const glm::dvec3& position_m) {
  const glm::dvec3 p = axis.shadow_from_gcrs * position_m;
  return {algebra::metres(std::hypot(p.x, p.y)),
          // FAULT position angles from the east: std::atan2(p.x, p.y) => std::atan2(p.y, p.x)
          algebra::within_circle(algebra::radians(std::atan2(p.x, p.y))), algebra::metres(p.z)};
}

ShadowPlace moon_in_shadow(const almanac::SkyState& sky) {
  return place_in_shadow(shadow_axis(sky), sky.moon_m);
}

ShadowPlace place_of_ground(const ShadowAxis& axis, const almanac::SkyState& sky,
                            const glm::dvec3& ground) {
  return place_in_shadow(axis,
                         sky.moon_m + glm::transpose(sky.selenographic_from_gcrs) *
                                          (algebra::in_metres(almanac::lunar_radius) * ground));
}

}  // namespace coppermoon::eclipse
