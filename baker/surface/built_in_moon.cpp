// SPDX-License-Identifier: MIT
#include "surface/built_in_moon.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "algebra/error.h"
#include "surface/albedo_map.h"
#include "surface/features.h"
#include "surface/moon_row.h"
#include "surface/noise.h"
#include "surface/tables.h"

namespace coppermoon::surface {
namespace {

using std::numbers::pi;

constexpr float highland_albedo = 0.158F;
constexpr float farthest_bent_rad = 0.15F;

/// Longitudes of a map's columns.
struct Meridians {
  std::vector<float> cosine, sine;

  explicit Meridians(std::size_t rows) {
    for (std::size_t c = 0; c < 2 * rows; ++c) {
      const double longitude = algebra::in_radians(texel_centre(0, c, rows).longitude);
      cosine.push_back(static_cast<float>(std::cos(longitude)));
      sine.push_back(static_cast<float>(std::sin(longitude)));
    }
  }
};

/// Noise of each octave a texel can show: three values bend the coasts, the fourth is the shade.
void add_octaves(MoonRow& row, std::size_t rows) {
  const float finest = static_cast<float>(rows) / 5;
  const Directions points{row.x, row.y, row.z};
  row.bent_x = row.x, row.bent_y = row.y, row.bent_z = row.z;
  row.shade.assign(row.x.size(), 0);
  row.grain = row.shade;
  float bend = 0.032F, shade = 0.08F;
  for (float f = 3; f < std::min(finest, 1600.0F); f *= 2, bend *= 0.66F, shade *= 0.76F)
    add_noise(points, f, {bend, bend, bend, shade},
              {row.bent_x, row.bent_y, row.bent_z, f < 40 ? row.shade : row.grain});
  for (std::size_t i = 0; i < row.shade.size(); ++i) row.shade[i] += row.grain[i];
  normalise_bent(row);
}

MoonRow started_row(std::size_t r, const Meridians& meridians, algebra::Grid<float>& map) {
  MoonRow row;
  row.latitude_rad = algebra::in_radians(texel_centre(r, 0, map.rows()).latitude);
  row.albedo = map.row(r);
  const auto c = static_cast<float>(std::cos(row.latitude_rad));
  const auto turned = [&](const std::vector<float>& of_meridians) {
    auto all = of_meridians;
    for (float& value : all) value *= c;
    return all;
  };
  row.x = turned(meridians.cosine);
  row.y = turned(meridians.sine);
  row.z.assign(map.columns(), static_cast<float>(std::sin(row.latitude_rad)));
  add_octaves(row, map.rows());
  return row;
}

/// Paints a feature over all columns that lie within an angle of its site, around the seam.
template <class Feature>
void paint_within(double reach_rad, const Feature& feature, MoonRow& row) {
  const Site& at = feature.at;
  if (std::abs(row.latitude_rad - at.latitude_rad) > reach_rad) return;
  const double cosine =
      (std::cos(reach_rad) - std::sin(row.latitude_rad) * std::sin(at.latitude_rad)) /
      (std::cos(row.latitude_rad) * std::cos(at.latitude_rad));
  if (cosine >= 1) return;
  const auto columns = static_cast<long>(row.x.size());
  const double per_radian = static_cast<double>(columns) / (2 * pi);
  const double middle = (at.longitude_rad + pi) * per_radian - 0.5;
  const double half = (cosine <= -1 ? pi : std::acos(cosine)) * per_radian;
  const long first = std::lround(std::floor(middle - half));
  const long count = std::min(std::lround(std::ceil(middle + half)) - first + 1, columns);
  const long from = (first % columns + columns) % columns, over = from + count - columns;
  const auto paint_some = [&](long begin, long end) {
    if (begin < end)
      paint(feature, {static_cast<std::size_t>(begin), static_cast<std::size_t>(end)}, row);
  };
  paint_some(from, std::min(from + count, columns));
  paint_some(0, over);
}

double reach_rad(const Patch& patch) {
  const float longest = std::max(patch.semi_east_rad, patch.semi_north_rad);
  return longest * (1.6F + patch.softness) + std::min(farthest_bent_rad, 0.8F * longest);
}

double reach_rad(const RayCrater& crater) {
  double reach = 7 * crater.radius_rad;
  for (const auto& ray : crater.rays) reach = std::max(reach, double{ray.length_rad});
  return reach;
}

void paint_row(std::size_t r, const Features& features, const Meridians& meridians,
               algebra::Grid<float>& map) {
  auto row = started_row(r, meridians, map);
  const double texel_rad = pi / static_cast<double>(map.rows());
  for (std::size_t c = 0; c < row.albedo.size(); ++c)
    row.albedo[c] = highland_albedo * (1 + row.shade[c]);
  for (const auto& patch : features.patches) paint_within(reach_rad(patch), patch, row);
  for (const auto& crater : features.old_craters)
    if (crater.radius_rad > texel_rad) paint_within(1.5 * crater.radius_rad, crater, row);
  for (const auto& crater : features.ray_craters) paint_within(reach_rad(crater), crater, row);
}

}  // namespace

algebra::Grid<float> built_in_moon(std::size_t rows) {
  algebra::require_within("rows of the built-in Moon", static_cast<double>(rows), 8, 32768);
  const auto found = features(tables::moon_features(), "moon_features");
  algebra::Grid<float> map(rows, 2 * rows);
  const Meridians meridians(rows);
  tbb::parallel_for(std::size_t{0}, rows,
                    [&](std::size_t r) { paint_row(r, found, meridians, map); });
  return map;
}

}  // namespace coppermoon::surface
