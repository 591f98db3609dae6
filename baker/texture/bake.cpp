// SPDX-License-Identifier: MIT
#include "texture/bake.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "algebra/error.h"
#include "atmosphere/figure.h"
#include "surface/albedo_map.h"

namespace coppermoon::texture {
namespace {

using algebra::Grid;

/// Means of a row of values over `count` equal parts of it.
void area_means(std::span<const float> row, std::span<float> means) {
  const double width = static_cast<double>(row.size()) / static_cast<double>(means.size());
  for (std::size_t i = 0; i < means.size(); ++i) {
    const double from = static_cast<double>(i) * width, to = from + width;
    double sum = 0;
    for (auto k = static_cast<std::size_t>(from); k < row.size() && static_cast<double>(k) < to;
         ++k) {
      const double left = std::max(from, static_cast<double>(k));
      sum += row[k] * (std::min(to, static_cast<double>(k) + 1) - left);
    }
    means[i] = static_cast<float>(sum / width);
  }
}

Grid<float> shrunk(const Grid<float>& map, std::size_t rows) {
  Grid<float> narrow(map.rows(), 2 * rows), small(rows, 2 * rows);
  for (std::size_t r = 0; r < map.rows(); ++r) area_means(map.row(r), narrow.row(r));
  std::vector<float> column(map.rows()), means(rows);
  for (std::size_t c = 0; c < 2 * rows; ++c) {
    for (std::size_t r = 0; r < map.rows(); ++r) column[r] = narrow(r, c);
    area_means(column, means);
    for (std::size_t r = 0; r < rows; ++r) small(r, c) = means[r];
  }
  return small;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// All that one texel needs to know.
struct Lighting {
  const almanac::SkyState& sky;
  const shadow::Lookup& light;
  eclipse::ShadowAxis axis;
  glm::dmat3 gcrs_from_selenographic;
  surface::Photometry photometry;

  double radiance_factor(const glm::dvec3& normal, const glm::dvec3& place,
                         const glm::dvec3& to_sun) const {
    const double earth_m = glm::length(place);
    const double phase_rad = std::max(angle_between(to_sun, -place),
                                      std::asin(atmosphere::earth_equatorial_radius_m / earth_m));
    return surface::radiance_factor(photometry, glm::dot(normal, to_sun) / glm::length(to_sun),
                                    -glm::dot(normal, place) / earth_m,
                                    algebra::radians(phase_rad));
  }

  void light_texel(const almanac::SelenographicPoint& at, double albedo, std::span<double> values,
                   std::span<float> texel) const {
    const glm::dvec3 normal = gcrs_from_selenographic * almanac::selenographic_direction(at);
    const glm::dvec3 place = sky.moon_m + algebra::in_metres(almanac::lunar_radius) * normal,
                     to_sun = sky.sun_m - place;
    if (albedo <= 0 || glm::dot(normal, to_sun) <= 0) return;
    const double near = almanac::astronomical_unit_m / glm::length(to_sun);
    const double reflected = albedo * radiance_factor(normal, place, to_sun) * near * near;
    light.read(eclipse::place_in_shadow(axis, place), values);
    for (std::size_t c = 0; c < texel.size(); ++c)
      texel[c] = static_cast<float>(reflected * values[c]);
  }
};

}  // namespace

Grid<float> resized(const Grid<float>& map, std::size_t rows) {
  algebra::require_within("texture height [texels]", static_cast<double>(rows), 2, 16384);
  if (map.columns() != 2 * map.rows() || map.empty())
    throw algebra::Error(
        fmt::format("albedo map is {} x {} texels, allowed 2:1", map.columns(), map.rows()));
  if (rows == map.rows()) return map;
  if (rows < map.rows()) return shrunk(map, rows);
  Grid<float> large(rows, 2 * rows);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) {
    for (std::size_t c = 0; c < large.columns(); ++c)
      large(r, c) = static_cast<float>(surface::sampled(map, surface::texel_centre(r, c, rows)));
  });
  return large;
}

Image bake(const Grid<float>& normal_albedo, const almanac::SkyState& sky,
           const shadow::Lookup& light, std::vector<std::string> channels, std::size_t rows,
           surface::Photometry photometry, const algebra::Progress& progress) {
  const auto albedo = resized(normal_albedo, rows);
  const Lighting lighting{sky, light, eclipse::shadow_axis(sky),
                          glm::transpose(sky.selenographic_from_gcrs), photometry};
  const std::size_t width = 2 * rows, count = light.channels();
  Image texture(width, rows, std::move(channels));
  std::atomic<std::size_t> done = 0;
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) {
    std::vector<double> values(count);
    for (std::size_t c = 0; c < width; ++c)
      lighting.light_texel(surface::texel_centre(r, c, rows), albedo(r, c), values,
                           std::span(texture.values).subspan((r * width + c) * count, count));
    if (progress) progress(static_cast<double>(++done) / static_cast<double>(rows));
  });
  return texture;
}

}  // namespace coppermoon::texture
