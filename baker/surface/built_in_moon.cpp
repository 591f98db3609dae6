// SPDX-License-Identifier: MIT
#include "surface/built_in_moon.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "algebra/error.h"
#include "surface/albedo_map.h"
#include "surface/features.h"
#include "surface/noise.h"
#include "surface/tables.h"

namespace coppermoon::surface {
namespace {

using std::numbers::pi;

constexpr float highland_albedo = 0.158F;
constexpr float farthest_bent_rad = 0.15F;

/// One row of the map on its way: where its texels are, and how the noise moves and shades them.
struct Row {
  double latitude_rad;
  std::vector<glm::vec3> points, bent;
  std::vector<float> shade, grain;
  std::span<float> albedo;
};

/// Noise of each octave a texel can show: three values bend the coasts, the fourth is the shade.
void add_octaves(Row& row, std::size_t rows) {
  const auto count = row.points.size();
  std::vector<Noise> coarse(count), fine(count);
  const float finest = static_cast<float>(rows) / 5;
  float bend = 0.032F, shade = 0.08F;
  for (float f = 3; f < std::min(finest, 1600.0F); f *= 2, bend *= 0.66F, shade *= 0.76F)
    add_noise(row.points, f, {bend, bend, bend, shade}, f < 40 ? coarse : fine);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& c = coarse[i];
    const auto& d = fine[i];
    row.bent[i] = glm::normalize(row.points[i] + glm::vec3(c[0] + d[0], c[1] + d[1], c[2] + d[2]));
    row.shade[i] = c[3] + d[3];
    row.grain[i] = d[3];
  }
}

Row started_row(std::size_t r, algebra::Grid<float>& map) {
  const auto rows = map.rows(), columns = map.columns();
  const auto at = texel_centre(r, 0, rows);
  Row row{algebra::in_radians(at.latitude), std::vector<glm::vec3>(columns),
          std::vector<glm::vec3>(columns),  std::vector<float>(columns),
          std::vector<float>(columns),      map.row(r)};
  for (std::size_t c = 0; c < columns; ++c)
    row.points[c] =
        site(row.latitude_rad, algebra::in_radians(texel_centre(r, c, rows).longitude)).up;
  add_octaves(row, rows);
  return row;
}

/// Acts on every column of a row that lies within an angle of a site, around the seam.
template <class Act>
void for_each_column_within(double reach_rad, const Site& at, const Row& row, Act act) {
  if (std::abs(row.latitude_rad - at.latitude_rad) > reach_rad) return;
  const double cosine =
      (std::cos(reach_rad) - std::sin(row.latitude_rad) * std::sin(at.latitude_rad)) /
      (std::cos(row.latitude_rad) * std::cos(at.latitude_rad));
  if (cosine >= 1) return;
  const auto columns = static_cast<long>(row.points.size());
  const double per_radian = static_cast<double>(columns) / (2 * pi);
  const double middle = (at.longitude_rad + pi) * per_radian - 0.5;
  const double half = (cosine <= -1 ? pi : std::acos(cosine)) * per_radian;
  const long first = std::lround(std::floor(middle - half));
  const long last = std::min(std::lround(std::ceil(middle + half)), first + columns - 1);
  for (long c = first; c <= last; ++c)
    act(static_cast<std::size_t>((c % columns + columns) % columns));
}

/// Where a point lies on the ground around a site: at its true distance, in its true direction.
struct Offset {
  float east, north, distance;
};

Offset offset(const Site& from, const glm::vec3& point) {
  const float x = glm::dot(point, from.east), y = glm::dot(point, from.north);
  const float sine = std::hypot(x, y);
  const float distance = std::atan2(sine, glm::dot(point, from.up));
  const float stretch = sine > 1e-6F ? distance / sine : 1;
  return {x * stretch, y * stretch, distance};
}

float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

void paint(const Patch& patch, Row& row) {
  const float longest = std::max(patch.semi_east_rad, patch.semi_north_rad);
  const float bent = std::min(farthest_bent_rad, 0.8F * longest);
  // A small patch keeps its place and shape: it is bent by no more than a part of its size.
  const float bending = std::min(1.0F, longest / 0.09F);
  const float ragged = 1.9F * smooth_step(0.015F, 0.06F, longest);
  for_each_column_within(
      longest * (1.6F + patch.softness) + bent, patch.at, row, [&](std::size_t c) {
        const auto [x, y, distance] =
            offset(patch.at, row.points[c] + bending * (row.bent[c] - row.points[c]));
        const float u = (x * patch.cos_turn + y * patch.sin_turn) / patch.semi_east_rad;
        const float v = (y * patch.cos_turn - x * patch.sin_turn) / patch.semi_north_rad;
        const float out = std::hypot(u, v) + ragged * row.shade[c];
        const float cover = 1 - smooth_step(1 - patch.softness, 1 + patch.softness, out);
        row.albedo[c] += cover * (patch.albedo * (1 + 1.2F * row.shade[c]) - row.albedo[c]);
      });
}

void paint(const OldCrater& crater, Row& row) {
  for_each_column_within(1.5 * crater.radius_rad, crater.at, row, [&](std::size_t c) {
    const float r = offset(crater.at, row.points[c]).distance / crater.radius_rad;
    const float wall = std::max(0.0F, 1 - std::abs(r - 0.9F) / 0.35F);
    const float floor = 1 - smooth_step(0.4F, 0.8F, r);
    row.albedo[c] *= 1 + crater.contrast * (wall - 0.45F * floor);
  });
}

/// How strongly the rays show at a place, 0 to 1.
float ray_strength(const RayCrater& crater, const Offset& at, float grain) {
  const float azimuth = std::atan2(at.east, at.north);
  float strength = 0;
  for (const auto& ray : crater.rays) {
    if (at.distance > ray.length_rad) continue;
    const auto turn = std::remainder(azimuth - ray.azimuth_rad, static_cast<float>(2 * pi));
    const float along = at.distance / ray.length_rad;
    const float aside = std::sin(std::min(std::abs(turn), 1.5F)) * std::sin(at.distance);
    const float wide = ray.half_width_rad * (1 + 1.8F * along) * (1 + 3 * grain);
    strength += ray.strength * std::exp(-aside * aside / (wide * wide)) * (1 - along * along);
  }
  return std::min(strength, 1.0F) * std::clamp(0.62F + 4.5F * grain, 0.1F, 1.0F);
}

void paint(const RayCrater& crater, Row& row) {
  double reach = 7 * crater.radius_rad;
  for (const auto& ray : crater.rays) reach = std::max(reach, double{ray.length_rad});
  for_each_column_within(reach, crater.at, row, [&](std::size_t c) {
    const auto at = offset(crater.at, row.points[c]);
    const float r = at.distance / crater.radius_rad;
    const float halo =
        r < 1 ? 0.7F + 0.3F * r : std::exp(-0.75F * (r - 1)) * (0.8F + 3 * row.grain[c]);
    const float rays = r < 1 ? 0 : 0.85F * ray_strength(crater, at, row.grain[c]);
    const float strength = std::clamp(std::max(0.85F * halo, rays), 0.0F, 1.0F);
    row.albedo[c] += strength * std::max(0.0F, crater.albedo - row.albedo[c]);
  });
}

void paint_row(std::size_t r, const Features& features, algebra::Grid<float>& map) {
  auto row = started_row(r, map);
  const double texel_rad = pi / static_cast<double>(map.rows());
  for (std::size_t c = 0; c < row.albedo.size(); ++c)
    row.albedo[c] = highland_albedo * (1 + row.shade[c]);
  for (const auto& patch : features.patches) paint(patch, row);
  for (const auto& crater : features.old_craters)
    if (crater.radius_rad > texel_rad) paint(crater, row);
  for (const auto& crater : features.ray_craters) paint(crater, row);
}

}  // namespace

algebra::Grid<float> built_in_moon(std::size_t rows) {
  algebra::require_within("rows of the built-in Moon", static_cast<double>(rows), 8, 32768);
  const auto found = features(tables::moon_features(), "moon_features");
  algebra::Grid<float> map(rows, 2 * rows);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) { paint_row(r, found, map); });
  return map;
}

}  // namespace coppermoon::surface
