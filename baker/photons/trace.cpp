// SPDX-License-Identifier: MIT
#include "photons/trace.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "algebra/error.h"

namespace coppermoon::photons {
namespace {

using atmosphere::Atmosphere;
using atmosphere::Column;
using atmosphere::Optics;

const Column& column_over(const Atmosphere& atmosphere, const glm::dvec3& at_m) {
  if (atmosphere.symmetric()) return atmosphere.column;
  return atmosphere.column_at(std::atan2(at_m.x, at_m.y));
}

glm::dvec3 refractivity_gradient(const Column& column, const Optics& optics, const glm::dvec3& at_m,
                                 double here, double earth_radius_m, double step_m) {
  glm::dvec3 gradient;
  for (int j = 0; j < 3; ++j) {
    glm::dvec3 beside = at_m;
    beside[j] += step_m;
    gradient[j] =
        (refractivity(column, optics, glm::length(beside) - earth_radius_m) - here) / step_m;
  }
  return gradient;
}

}  // namespace

std::optional<Ray> entered(const Ray& ray, double radius_m) {
  const double along = -glm::dot(ray.position_m, ray.direction);
  const glm::dvec3 nearest = ray.position_m + along * ray.direction;
  const double half_chord_squared = radius_m * radius_m - glm::dot(nearest, nearest);
  if (along < 0 || half_chord_squared <= 0) return std::nullopt;
  return Ray{nearest - std::sqrt(half_chord_squared) * ray.direction, ray.direction};
}

std::optional<Traced> trace(const Ray& entering, const Atmosphere& atmosphere, const Optics& optics,
                            const Stepping& stepping) {
  algebra::require_within("step [m]", stepping.step_m, 1, 1e5);
  const double length = stepping.step_m, earth_radius_m = atmosphere.earth_radius_m;
  glm::dvec3 at = entering.position_m, direction = entering.direction;
  double optical_depth = 0;
  int steps = 0;
  for (double altitude = glm::length(at) - earth_radius_m;
       altitude <= atmosphere.top_m || glm::dot(at, direction) < 0;
       altitude = glm::length(at) - earth_radius_m, ++steps) {
    if (altitude < 0) return std::nullopt;
    const Column& column = column_over(atmosphere, at);
    const double here = refractivity(column, optics, altitude);
    optical_depth += extinction_per_m(column, optics, altitude) * length;
    const glm::dvec3 momentum =
        (1 + here) * direction + length * refractivity_gradient(column, optics, at, here,
                                                                earth_radius_m,
                                                                stepping.gradient_step_m);
    at += length * direction;
    const double there = refractivity(column, optics, glm::length(at) - earth_radius_m);
    direction = momentum / (1 + there);
  }
  const double ozone = ozone_transmittance(column_over(atmosphere, at), optics);
  return Traced{{at, glm::normalize(direction)}, std::exp(-optical_depth) * ozone, steps};
}

}  // namespace coppermoon::photons
