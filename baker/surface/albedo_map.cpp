// SPDX-License-Identifier: MIT
#include "surface/albedo_map.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "algebra/error.h"
#include "surface/photometry.h"

namespace coppermoon::surface {
namespace {

using algebra::Grid;
using std::numbers::pi;

constexpr std::size_t fewest_disc_rows = 180;

void require_two_to_one(const Grid<float>& map) {
  if (map.empty() || map.columns() != 2 * map.rows())
    throw algebra::Error(
        fmt::format("albedo map is {} x {} texels, allowed 2:1", map.columns(), map.rows()));
}

struct Neighbours {
  std::size_t before, after;
  double t;
};

Neighbours around(double longitude_rad, std::size_t columns) {
  const auto n = static_cast<double>(columns);
  double x = (longitude_rad / (2 * pi) + 0.5) * n - 0.5;
  x -= n * std::floor(x / n);
  const auto i = std::min(static_cast<std::size_t>(x), columns - 1);
  return {i, (i + 1) % columns, x - static_cast<double>(i)};
}

Neighbours between_poles(double latitude_rad, std::size_t rows) {
  const auto n = static_cast<double>(rows);
  const double y = std::clamp((0.5 - latitude_rad / pi) * n - 0.5, 0.0, n - 1);
  const auto i = static_cast<std::size_t>(y);
  return {i, std::min(i + 1, rows - 1), y - static_cast<double>(i)};
}

/// Sums over the texels of the disc that is seen from above latitude 0, longitude 0.
struct DiscSum {
  double light = 0, area = 0;
};

DiscSum disc_sum(const Grid<float>& map, Photometry photometry, std::size_t rows, std::size_t r,
                 std::span<const double> cos_longitude) {
  DiscSum sum;
  const double cos_latitude = std::cos(algebra::in_radians(texel_centre(r, 0, rows).latitude));
  for (std::size_t c = rows / 2; c < 2 * rows - rows / 2; ++c) {
    const double mu = cos_latitude * cos_longitude[c];
    const double on_disc = std::max(mu, 0.0) * cos_latitude;
    const double albedo = rows == map.rows() ? map(r, c) : sampled(map, texel_centre(r, c, rows));
    sum.light += on_disc * albedo * radiance_factor_at_full_moon(photometry, mu);
    sum.area += on_disc;
  }
  return sum;
}

}  // namespace

almanac::SelenographicPoint texel_centre(std::size_t row, std::size_t column, std::size_t rows) {
  const double step = pi / static_cast<double>(rows);
  return {algebra::radians(pi / 2 - (static_cast<double>(row) + 0.5) * step),
          algebra::radians(-pi + (static_cast<double>(column) + 0.5) * step)};
}

double sampled(const Grid<float>& map, const almanac::SelenographicPoint& at) {
  if (map.empty()) throw algebra::Error("albedo map is empty");
  const auto [west, east, u] = around(algebra::in_radians(at.longitude), map.columns());
  const auto [north, south, v] = between_poles(algebra::in_radians(at.latitude), map.rows());
  const double upper = (1 - u) * map(north, west) + u * map(north, east);
  const double lower = (1 - u) * map(south, west) + u * map(south, east);
  return (1 - v) * upper + v * lower;
}

double geometric_albedo(const Grid<float>& map, Photometry photometry) {
  require_two_to_one(map);
  const std::size_t finer = (fewest_disc_rows + map.rows() - 1) / map.rows();
  const std::size_t rows = finer * map.rows();
  std::vector<double> cos_longitude(2 * rows);
  for (std::size_t c = 0; c < 2 * rows; ++c)
    cos_longitude[c] = std::cos(algebra::in_radians(texel_centre(0, c, rows).longitude));
  std::vector<DiscSum> sums(rows);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t r) {
    sums[r] = disc_sum(map, photometry, rows, r, cos_longitude);
  });
  DiscSum all;
  for (const auto& row : sums) all.light += row.light, all.area += row.area;
  return all.light / all.area;
}

double kit_2019_albedo(double code) {
  return std::pow(0.16 + 0.24 * code, 2.8 * exponent_to_full_moon);
}

Grid<float> with_polar_contrast(Grid<float> map) {
  constexpr double fades_from = 64, faded_at = 70, faded_to = 0.37;
  tbb::parallel_for(std::size_t{0}, map.rows(), [&](std::size_t r) {
    const double latitude = std::abs(algebra::in_degrees(texel_centre(r, 0, map.rows()).latitude));
    const double fade = std::lerp(
        1, faded_to, std::clamp((latitude - fades_from) / (faded_at - fades_from), 0., 1.));
    const auto row = map.row(r);
    const double mean = std::reduce(row.begin(), row.end(), 0.) / static_cast<double>(row.size());
    if (fade == 1 || !(mean > 0)) return;
    for (float& value : row) value = static_cast<float>(mean * std::pow(value / mean, 1 / fade));
  });
  return map;
}

Grid<float> normalised_to_geometric_albedo(Grid<float> map, Photometry photometry,
                                           double geometric) {
  algebra::require_within("geometric albedo", geometric, 0.01, 1);
  const double found = geometric_albedo(map, photometry);
  if (!(found > 0 && std::isfinite(found)))
    throw algebra::Error(
        fmt::format("the albedo map's near side has mean {:g}, allowed above 0", found));
  const auto scale = geometric / found;
  tbb::parallel_for(std::size_t{0}, map.rows(), [&](std::size_t r) {
    for (float& value : map.row(r)) value = static_cast<float>(value * scale);
  });
  return map;
}

}  // namespace coppermoon::surface
