// SPDX-License-Identifier: MIT
#include "uses/light/disc_brightness.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "surface/albedo_map.h"

namespace coppermoon::uses {
namespace {

/// Calls `add(row, column, solid angle)` for every texel that faces a place.
void for_each_seen(std::size_t rows, const almanac::SkyState& sky, const glm::dvec3& from_m,
                   const std::function<void(std::size_t, std::size_t, double)>& add) {
  const glm::dmat3 gcrs_from_selenographic = glm::transpose(sky.selenographic_from_gcrs);
  const double radius = algebra::in_metres(almanac::lunar_radius);
  const double step = std::numbers::pi / static_cast<double>(rows);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < 2 * rows; ++c) {
      const auto at = surface::texel_centre(r, c, rows);
      const double latitude = algebra::in_radians(at.latitude);
      const glm::dvec3 normal = gcrs_from_selenographic * almanac::selenographic_direction(at);
      const glm::dvec3 place = sky.moon_m - from_m + radius * normal;
      const double distance = glm::length(place),
                   cos_emission = -glm::dot(normal, place) / distance;
      const double area =
          radius * radius * step * (std::sin(latitude + step / 2) - std::sin(latitude - step / 2));
      if (cos_emission > 0) add(r, c, cos_emission * area / (distance * distance));
    }
}

}  // namespace

std::vector<double> irradiance_of_disc(const texture::Image& texture, const almanac::SkyState& sky,
                                       const glm::dvec3& from_m) {
  std::vector<double> sums(texture.channels.size());
  for_each_seen(texture.height, sky, from_m, [&](std::size_t r, std::size_t c, double solid_angle) {
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += solid_angle * texture(r, c, k);
  });
  return sums;
}

double solid_angle_of_disc(std::size_t rows, const almanac::SkyState& sky,
                           const glm::dvec3& from_m) {
  double sum = 0;
  for_each_seen(rows, sky, from_m,
                [&](std::size_t, std::size_t, double solid_angle) { sum += solid_angle; });
  return sum;
}

double danjon_estimate(double visual_magnitude) {
  const double root = std::sqrt(std::max(0., 4.8 + visual_magnitude));
  return std::clamp(6 - 2 * root, 0., 4.);
}

}  // namespace coppermoon::uses
