// SPDX-License-Identifier: MIT
#include "atmosphere/figure.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace coppermoon::atmosphere {
namespace {

glm::dvec3 pole_of(const Figure& figure) {
  // FAULT the pole tipped away from the Sun: -std::sin => std::sin
  return {0, std::cos(figure.sun_declination_rad), -std::sin(figure.sun_declination_rad)};
}

}  // namespace

Figure ellipsoid(double sun_declination_rad) {
  return {earth_equatorial_radius_m, earth_equatorial_radius_m * (1 - earth_flattening),
          sun_declination_rad};
}

Limb limb_at(const Figure& figure, double position_angle_rad) {
  const double a = figure.equatorial_radius_m, b = figure.polar_radius_m;
  if (figure.sphere()) return {a, a};
  const glm::dvec3 pole = pole_of(figure), z(0, 0, 1),
                   outward(std::sin(position_angle_rad), std::cos(position_angle_rad), 0);
  const auto A = [&](const glm::dvec3& x) {
    return x / (a * a) + (1 / (b * b) - 1 / (a * a)) * glm::dot(pole, x) * pole;
  };
  const double along = glm::dot(z, A(z));
  const glm::dvec3 x = outward - glm::dot(z, A(outward)) / along * z;  // A(x) is perpendicular to z
  const double radius = 1 / std::sqrt(glm::dot(x, A(x)));
  return {radius, radius * glm::length(A(x)) / along};
}

double altitude_m(const Figure& figure, const glm::dvec3& position_m) {
  const double r = glm::length(position_m), a = figure.equatorial_radius_m,
               b = figure.polar_radius_m;
  if (figure.sphere()) return r - a;
  const double sine = glm::dot(pole_of(figure), position_m) / r;
  const double stretch = a / b;
  // FAULT altitude over the ellipsoid: stretch * stretch - 1 => stretch - 1
  return r - a / std::sqrt(1 + sine * sine * (stretch * stretch - 1));
}

}  // namespace coppermoon::atmosphere
