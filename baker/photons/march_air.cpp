// SPDX-License-Identifier: MIT
#include "photons/march_air.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace coppermoon::photons {
namespace {

using atmosphere::Column;
using atmosphere::ValueAndSlope;

constexpr double cell_m = 50;
constexpr double below_ground_m = 2000;
constexpr double inside_m = 1e-6;  // distance from a break at which its sides are sampled

/// Profiles of a column as functions of the reduced height.
struct Along {
  const Column& column;
  double earth_radius_m;

  double altitude_m(double q) const { return altitude_of_reduced_m(q, earth_radius_m); }
  ValueAndSlope density(double q) const {
    const double h = altitude_m(q);
    const auto density = atmosphere::density_ratio(column, h);
    return {density.value, density.slope_per_m / (1 + h / earth_radius_m)};
  }
  atmosphere::Amounts profiles(double q) const {
    return atmosphere::profiles(column, altitude_m(q));
  }
};

/// Distance below a break at which the layer under it is sampled; more at the top, as US 1976 ends a little below
/// 86 km.
double inside_below_m(const Column& column, bool top) {
  return top && column.density == atmosphere::Density::us_1976 ? 1 : inside_m;
}

/// Part of a cell that lies within one layer.
struct Part {
  double from_m, to_m;  ///< reduced heights
  double begin;         ///< beginning of the cell, relative to `from_m`
};

std::vector<std::size_t> others_in(const Column& column) {
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < atmosphere::absorbers; ++k)
    if (k != atmosphere::air && atmosphere::has(column, static_cast<atmosphere::Absorber>(k)))
      others.push_back(k);
  return others;
}

/// Coefficients of the cubic with given values and slopes at both ends of a part, in the cell's variable, 0 to 1.
std::array<double, 4> cubic(const Part& part, const ValueAndSlope& low, const ValueAndSlope& high) {
  constexpr double too_short_m = 1;
  const double width = part.to_m - part.from_m, s = part.begin;
  if (width < too_short_m) return {low.value + low.slope_per_m * s, low.slope_per_m * cell_m, 0, 0};
  const double chord = (high.value - low.value) / width;
  const double second = (3 * chord - 2 * low.slope_per_m - high.slope_per_m) / width;
  const double third = (low.slope_per_m + high.slope_per_m - 2 * chord) / (width * width);
  return {low.value + s * (low.slope_per_m + s * (second + s * third)),
          cell_m * (low.slope_per_m + s * (2 * second + 3 * s * third)),
          cell_m * cell_m * (second + 3 * s * third), cell_m * cell_m * cell_m * third};
}

/// Value and slope of a profile's chord, shifted so that its mean is the profile's (by Simpson's rule).
std::array<double, 2> line(const Part& part, double low, double middle, double high) {
  const double width = part.to_m - part.from_m;
  const double slope = width > 0 ? (high - low) / width : 0;
  return {low + 2. / 3 * (middle - (low + high) / 2) + slope * part.begin, slope * cell_m};
}

template <class T>
void add_cell(const Along& air, const Part& part, MarchAir<T>& out) {
  for (const double c : cubic(part, air.density(part.from_m), air.density(part.to_m)))
    out.cells.push_back(static_cast<T>(c));
  const auto low = air.profiles(part.from_m), high = air.profiles(part.to_m),
             middle = air.profiles((part.from_m + part.to_m) / 2);
  for (const std::size_t k : out.others)
    for (const double c : line(part, low[k], middle[k], high[k]))
      out.cells.push_back(static_cast<T>(c));
}

template <class T>
void add_layer(const Along& air, double from_m, double to_m, bool top, MarchAir<T>& out) {
  const double highest = to_m - inside_below_m(air.column, top);
  const auto first = static_cast<int>(std::floor(from_m / cell_m)),
             last = static_cast<int>(std::floor(to_m / cell_m));
  for (int i = first; i <= last; ++i) {
    const double begin = i * cell_m;
    Part part{std::max(begin, from_m + inside_m), std::min(begin + cell_m, highest), 0};
    if (part.to_m < part.from_m) part.from_m = part.to_m;
    part.begin = begin - part.from_m;
    add_cell(air, part, out);
  }
  out.lower_m.push_back(static_cast<T>(from_m));
  out.upper_m.push_back(static_cast<T>(to_m));
}

/// Density, slope and curvature beside a break.
std::array<double, 3> beside(const Along& air, double at_m, double away_m) {
  const auto here = air.density(at_m), there = air.density(at_m + away_m);
  return {here.value, here.slope_per_m, (there.slope_per_m - here.slope_per_m) / away_m};
}

template <class T>
void add_border(const Along& air, double at_m, bool top, MarchAir<T>& out) {
  constexpr double near_m = 10;
  const double highest = at_m - inside_below_m(air.column, top), lowest = at_m + inside_m;
  const auto below = beside(air, highest, -near_m);
  const auto above = top ? std::array<double, 3>{} : beside(air, lowest, near_m);
  out.borders.push_back(static_cast<T>(below[0]));
  out.borders.push_back(static_cast<T>(top ? -below[0] : 0));
  for (std::size_t j = 1; j < below.size(); ++j)
    out.borders.push_back(static_cast<T>(above[j] - below[j]));
  const auto under = air.profiles(highest);
  const auto over = top ? atmosphere::Amounts{} : air.profiles(lowest);
  for (const std::size_t k : out.others) out.borders.push_back(static_cast<T>(over[k] - under[k]));
}

/// Adds the last layer, empty space, high enough for a ray that has left the air in its last step.
template <class T>
void add_space(double from_m, MarchAir<T>& out) {
  constexpr T infinity = std::numeric_limits<T>::infinity();
  out.cells.resize(out.cells.size() + 2 * out.terms(), 0);
  out.lower_m.front() = -infinity;
  out.lower_m.push_back(-infinity);
  out.upper_m.push_back(infinity);
  out.borders.resize(out.borders.size() + out.terms_of_border(), 0);
  out.highest_m = static_cast<T>(from_m);
}

}  // namespace

double reduced_height_m(double altitude_m, double earth_radius_m) {
  return altitude_m + altitude_m * altitude_m / (2 * earth_radius_m);
}

double altitude_of_reduced_m(double reduced_m, double earth_radius_m) {
  return 2 * reduced_m / (1 + std::sqrt(1 + 2 * reduced_m / earth_radius_m));
}

template <class T>
MarchAir<T> march_air(const Column& column, double earth_radius_m) {
  const Along air{column, earth_radius_m};
  MarchAir<T> out{};
  out.others = others_in(column);
  out.earth_radius_m = static_cast<T>(earth_radius_m);
  out.cells_per_m = static_cast<T>(1 / cell_m);
  out.cells_below_ground = static_cast<T>(below_ground_m / cell_m);
  out.lowest_m = static_cast<T>(-below_ground_m);
  const auto breaks = atmosphere::breaks_m(column);
  double from_m = -below_ground_m;
  for (const double h : breaks) {
    const double to_m = reduced_height_m(h, earth_radius_m);
    if (to_m <= 0) continue;
    const bool top = h == breaks.back();
    add_layer(air, from_m, to_m, top, out);
    add_border(air, to_m, top, out);
    from_m = to_m;
  }
  if (!out.lower_m.empty()) add_space(from_m, out);
  return out;
}

template MarchAir<float> march_air(const Column&, double);
template MarchAir<double> march_air(const Column&, double);

}  // namespace coppermoon::photons
