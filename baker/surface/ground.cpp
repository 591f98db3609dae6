// SPDX-License-Identifier: MIT
#include "surface/ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"
#include "algebra/table.h"
#include "surface/albedo_map.h"
#include "surface/tables.h"

namespace coppermoon::surface {
namespace {

using algebra::Grid;
using std::numbers::pi;

constexpr int smoothings = 2;

/// Reads a table of whole numbers into a grid, and multiplies each number by a unit.
Grid<float> grid_of(std::string_view text, double unit) {
  const auto lines = algebra::parse_text_table(text);
  Grid<float> grid(lines.size(), lines.front().size());
  for (std::size_t r = 0; r < grid.rows(); ++r)
    for (std::size_t c = 0; c < grid.columns(); ++c)
      grid(r, c) = static_cast<float>(algebra::number_in(lines.at(r).at(c)).value() * unit);
  return grid;
}

/// Smooths a map with a binomial filter of 3 rows by 3 columns. The first and last columns count as neighbours; the
/// first and last rows are repeated beyond the map's edges.
Grid<float> smoothed(const Grid<float>& map) {
  const std::size_t rows = map.rows(), columns = map.columns();
  const auto binomial = [](float a, float b, float c) { return (a + 2 * b + c) / 4; };
  Grid<float> along(rows, columns), both(rows, columns);
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c)
      along(r, c) =
          binomial(map(r, (c + columns - 1) % columns), map(r, c), map(r, (c + 1) % columns));
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c)
      both(r, c) =
          binomial(along(r == 0 ? 0 : r - 1, c), along(r, c), along(std::min(r + 1, rows - 1), c));
  return both;
}

/// Poisson kernel at evenly spaced angles, normalised to a sum of 1. With these weights, values on the unit circle are
/// averaged to give the harmonic function on a smaller circle.
std::vector<float> poisson_kernel(std::size_t count, double radius) {
  std::vector<float> kernel(count);
  double sum = 0;
  const auto value = [&](std::size_t i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
    return (1 - radius * radius) / (1 - 2 * radius * std::cos(angle) + radius * radius);
  };
  for (std::size_t i = 0; i < count; ++i) sum += value(i);
  for (std::size_t i = 0; i < count; ++i) kernel[i] = static_cast<float>(value(i) / sum);
  return kernel;
}

/// Fills one row of a polar cap from the nearest measured row, with a harmonic function: each wave cos m λ along the
/// row decreases towards the pole as tan^m(colatitude/2).
void continue_harmonically(Grid<float>& map, std::size_t measured, std::size_t row) {
  const auto half_colatitude = [&](std::size_t r) {
    const std::size_t from_pole = std::min(r, map.rows() - 1 - r);
    return pi / 2 * (static_cast<double>(from_pole) + 0.5) / static_cast<double>(map.rows());
  };
  const auto kernel = poisson_kernel(
      map.columns(), std::tan(half_colatitude(row)) / std::tan(half_colatitude(measured)));
  const auto from = map.row(measured);
  for (std::size_t c = 0; c < map.columns(); ++c) {
    float sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
      sum += kernel[(i + from.size() - c) % from.size()] * from[i];
    map(row, c) = sum;
  }
}

/// Extends a map of the lower latitudes to the poles.
Grid<float> to_the_poles(const Grid<float>& middle) {
  Grid<float> whole(middle.columns() / 2, middle.columns());
  const std::size_t missing = (whole.rows() - middle.rows()) / 2, last = whole.rows() - missing - 1;
  for (std::size_t r = missing; r <= last; ++r)
    std::ranges::copy(middle.row(r - missing), whole.row(r).begin());
  for (std::size_t r = 0; r < missing; ++r) {
    continue_harmonically(whole, missing, r);
    continue_harmonically(whole, last, whole.rows() - 1 - r);
  }
  return whole;
}

Grid<float> measured(Grid<float> map) {
  for (int i = 0; i < smoothings; ++i) map = smoothed(map);
  return to_the_poles(map);
}

/// Subtracts from the maps of colour and surge their means over the full Moon's disc, weighted by reflected light.
void subtract_means(Ground& ground, const Grid<float>& normal_albedo, Photometry photometry) {
  constexpr std::size_t rows = 360;  // rows of half a degree, finer than either map
  double light = 0, colour = 0, surge = 0;
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = rows / 2; c < rows + rows / 2; ++c) {
      const auto at = texel_centre(r, c, rows);
      const double cosine = std::cos(algebra::in_radians(at.latitude)),
                   mu = cosine * std::cos(algebra::in_radians(at.longitude));
      const double weight =
          mu * cosine * sampled(normal_albedo, at) * radiance_factor_at_full_moon(photometry, mu);
      light += weight;
      colour += weight * sampled(ground.colour, at);
      surge += weight * sampled(ground.surge, at);
    }
  if (!(light > 0 && std::isfinite(light)))
    throw algebra::Error(
        fmt::format("the albedo map's near side has mean {:g}, allowed above 0", light));
  for (float& value : ground.colour.values()) value -= static_cast<float>(colour / light);
  for (float& value : ground.surge.values()) value -= static_cast<float>(surge / light);
}

/// Derivative of the logarithm of Hapke's opposition surge with respect to its amplitude: B(g) / (1 + Bs0 B(g) + m).
double share_of_surge(algebra::Angle phase) {
  constexpr double amplitude = 1.87, width = 0.073, more_than_once = 0.158;
  const double b = 1 / (1 + std::tan(algebra::in_radians(phase) / 2) / width);
  return b / (1 + amplitude * b + more_than_once);
}

}  // namespace

Ground measured_ground() {
  auto ratio = grid_of(tables::lunar_blue_ratio(), 1e-3);
  for (float& value : ratio.values()) value = std::log(value);
  return {measured(std::move(ratio)), measured(grid_of(tables::lunar_surge_amplitude(), 1e-2))};
}

Ground ground_under(const Grid<float>& normal_albedo, Photometry photometry) {
  auto ground = measured_ground();
  subtract_means(ground, normal_albedo, photometry);
  constexpr auto most = static_cast<float>(strongest_colour);
  for (float& c : ground.colour.values()) c = std::clamp(c, -most, most);
  return ground;
}

double colour_spectrum(algebra::Wavelength wavelength) {
  const double lambda = algebra::in_nanometres(wavelength);
  algebra::require_within("wavelength [nm]", lambda, 380, 780);
  const double x = lambda - 566;
  return (-5.4578e-3 + 7.7136e-6 * x) * x;
}

double surge_slope(Photometry photometry, algebra::Angle phase) {
  if (photometry == Photometry::yapo_cutler) return 0;
  return share_of_surge(phase) - share_of_surge(full_moon_phase);
}

}  // namespace coppermoon::surface
