// SPDX-License-Identifier: MIT
#include "shadow/sights.h"

#include <algorithm>
#include <cmath>

#include "algebra/quadrature.h"

namespace coppermoon::shadow {
namespace {

using atmosphere::Amounts;
using atmosphere::Column;

constexpr int nodes_a_piece = 4, points_a_sight = 48;
constexpr double height_step_m = 500, along_step_m = 10e3;  // steps of the table in Slants

/// Half the length of a sphere's chord at the given distance from the sphere's centre.
double half_chord_m(double sphere_m, double away_m) {
  return std::sqrt((sphere_m - away_m) * (sphere_m + away_m));
}

Amounts sum(const Amounts& a, const Amounts& b, double share_of_b = 1) {
  Amounts both = a;
  for (std::size_t k = 0; k < both.size(); ++k) both[k] += share_of_b * b[k];
  return both;
}

/// Altitudes at which the quadrature over lines of sight is divided, because the profiles change there.
std::vector<double> stations(const Column& column) {
  const double top = top_m(column);
  std::vector<double> heights{0, 5e3, 10e3, 15e3, 20e3, 25e3, 30e3, 40e3, 55e3, top};
  if (column.cloud_cover > 0) heights.push_back(column.cloud_top_m);
  if (column.dust_extinction_per_m > 0)
    heights.insert(heights.end(), {column.dust_bottom_m, column.dust_top_m});
  std::erase_if(heights, [&](double h) { return h > top; });
  std::sort(heights.begin(), heights.end());
  return heights;
}

/// Layer of air at one node of the quadrature over heights.
struct Layer {
  double height_m, width_m;
};

void add_sight(const Column& column, const Slants& slants, double radius_m, const Layer& layer,
               std::vector<SightPoint>& points) {
  const double impact = radius_m + layer.height_m;
  const double reach = half_chord_m(radius_m + top_m(column), impact);
  const double step = 2 * reach / points_a_sight;
  for (int i = 0; i < points_a_sight; ++i) {
    const double along = (i + 0.5) * step - reach;
    const double altitude = std::hypot(impact, along) - radius_m;
    points.push_back({impact, along, altitude, along < 0 ? layer.height_m : altitude,
                      sum({}, profiles(column, altitude), impact * layer.width_m * step),
                      slants.up_to(layer.height_m, -along)});
  }
}

}  // namespace

Slants::Slants(const Column& column, const photons::ProfileTable& profiles, double radius_m)
    : top_m_(top_m(column)) {
  const auto lines = static_cast<std::size_t>(std::ceil(top_m_ / height_step_m)) + 1;
  const double reach_m = half_chord_m(radius_m + top_m_, radius_m);
  const auto places = static_cast<std::size_t>(std::ceil(reach_m / along_step_m)) + 1;
  outwards_ = algebra::Grid<Amounts>(lines, places);
  for (std::size_t i = 0; i < lines; ++i)
    for (std::size_t j = places - 1; j-- > 0;)
      outwards_(i, j) = sum(outwards_(i, j + 1), between(profiles, radius_m, i, j));
}

Amounts Slants::beyond(double lowest_m, double along_m) const {
  const double row = std::max(0., lowest_m) / height_step_m, place = along_m / along_step_m;
  const auto i = static_cast<std::size_t>(row), j = static_cast<std::size_t>(place);
  if (i + 1 >= outwards_.rows() || j + 1 >= outwards_.columns()) return {};
  const double v = row - static_cast<double>(i), u = place - static_cast<double>(j);
  const auto &here = outwards_(i, j), &further = outwards_(i, j + 1), &higher = outwards_(i + 1, j),
             &both = outwards_(i + 1, j + 1);
  Amounts amounts{};
  for (std::size_t k = 0; k < amounts.size(); ++k)
    amounts[k] =
        (1 - v) * ((1 - u) * here[k] + u * further[k]) + v * ((1 - u) * higher[k] + u * both[k]);
  return amounts;
}

Amounts Slants::up_to(double lowest_m, double along_m) const {
  if (along_m < 0) return beyond(lowest_m, -along_m);
  const auto half = beyond(lowest_m, 0);
  return sum(sum(half, half), beyond(lowest_m, along_m), -1);
}

Amounts Slants::between(const photons::ProfileTable& profiles, double radius_m, std::size_t i,
                        std::size_t j) const {
  const double lowest_m = radius_m + static_cast<double>(i) * height_step_m;
  Amounts amounts{};
  for (const auto& [x, weight] : algebra::gauss_legendre(3)) {
    const double along_m = (static_cast<double>(j) + (1 + x) / 2) * along_step_m;
    const double altitude_m = std::hypot(lowest_m, along_m) - radius_m;
    if (altitude_m < top_m_)
      amounts = sum(amounts, profiles(altitude_m), weight / 2 * along_step_m);
  }
  return amounts;
}

std::vector<SightPoint> points_on_sights(const Column& column, const Slants& slants,
                                         double radius_m) {
  std::vector<SightPoint> points;
  const auto ends = stations(column);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    for (const auto& [x, weight] : algebra::gauss_legendre(nodes_a_piece)) {
      const double width = (ends[i + 1] - ends[i]) / 2;
      if (width > 0)
        add_sight(column, slants, radius_m, {ends[i] + (1 + x) * width, weight * width}, points);
    }
  return points;
}

}  // namespace coppermoon::shadow
