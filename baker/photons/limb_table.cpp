// SPDX-License-Identifier: MIT
#include "photons/limb_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "algebra/error.h"

namespace coppermoon::photons {
namespace {

using atmosphere::Column;
using atmosphere::Optics;

/// Where rays must stand: the ground, the breaks, the cloud's top, the air's.
std::vector<double> stations(const Column& column) {
  auto heights = atmosphere::breaks_m(column);
  heights.push_back(0);
  if (column.cloud_cover > 0) heights.push_back(column.cloud_top_m);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

/// The air above 50 km bends and dims so little that few rays will do.
double importance(double low_m, double high_m) {
  constexpr double thin_m = 50e3, little = 0.25;
  return (high_m - low_m) * (low_m < thin_m ? 1 : little);
}

/// A stretch of tangent heights without a break, with rays ever closer towards its upper end, where
/// the square roots are: evenly spaced in √(high − h).
struct Piece {
  double low_m, high_m;
  int rays;

  /// Given  place  0 at the lower end to `rays` at the upper
  double height_m(double place) const {
    const double left = 1 - place / rays;
    return high_m - (high_m - low_m) * left * left;
  }
};

std::vector<Piece> pieces_of(const Column& column, int rays) {
  const auto ends = stations(column);
  double all = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) all += importance(ends[i], ends[i + 1]);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double share = importance(ends[i], ends[i + 1]) / all;
    pieces.push_back({ends[i], ends[i + 1], std::max(4, static_cast<int>(rays * share))});
  }
  return pieces;
}

/// Chebyshev's places between the least and the greatest refractivity.
std::vector<double> chebyshev(double least, double greatest) {
  if (!(greatest - least > 1e-9 * greatest)) return {greatest};
  const double middle = (least + greatest) / 2, half = (greatest - least) / 2;
  return {middle - half * std::sqrt(0.75), middle, middle + half * std::sqrt(0.75)};
}

/// Lagrange's weights of the nodes for a value between them.
std::vector<double> lagrange(std::span<const double> nodes, double at) {
  std::vector<double> weights(nodes.size(), 1);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if (j != i) weights[i] *= (at - nodes[j]) / (nodes[i] - nodes[j]);
  return weights;
}

/// Paths over one piece, without its upper end: those followed, and between each two of them more
/// by cubics through the four nearest.
void add_paths(const Piece& piece, const std::function<LimbPath(double)>& followed,
               std::vector<LimbPath>& paths) {
  std::vector<LimbPath> nodes;
  for (int k = 0; k <= piece.rays; ++k) nodes.push_back(followed(piece.height_m(k)));
  for (int i = 0; i < piece.rays * LimbTable::finer; ++i) {
    const double place = static_cast<double>(i) / LimbTable::finer;
    const int first = std::clamp(static_cast<int>(place) - 1, 0, piece.rays - 3);
    const std::array<double, 4> near{first + 0., first + 1., first + 2., first + 3.};
    const auto shares = lagrange(near, place);
    LimbPath path{piece.height_m(place), 0, 0, {}};
    for (std::size_t j = 0; j < near.size(); ++j) {
      const auto& node = nodes[static_cast<std::size_t>(first) + j];
      path.bending_rad += shares[j] * node.bending_rad;
      for (std::size_t a = 0; a < path.amounts.size(); ++a)
        path.amounts[a] += shares[j] * node.amounts[a];
    }
    paths.push_back(path);
  }
}

}  // namespace

LimbTable::LimbTable(const Column& column, double earth_radius_m, std::span<const Optics> optics,
                     int rays)
    : column_(column), earth_radius_m_(earth_radius_m) {
  const auto [least, greatest] = std::ranges::minmax(optics, {}, &Optics::refractivity);
  refractivities_ = column.refraction ? chebyshev(least.refractivity, greatest.refractivity)
                                      : std::vector<double>{0};
  for (const double refractivity : refractivities_) {
    const auto followed = [&](double height) {
      return limb_path(height, earth_radius_m, column, refractivity);
    };
    auto& paths = paths_.emplace_back();
    for (const auto& piece : pieces_of(column, rays)) add_paths(piece, followed, paths);
    paths.push_back(followed(atmosphere::top_m(column)));
  }
  for (const auto& path : paths_.front()) tangent_heights_m_.push_back(path.tangent_height_m);
}

Fan LimbTable::fan(const Optics& optics) const {
  const auto shares = lagrange(refractivities_, optics.refractivity);
  const auto spectra = atmosphere::spectra(column_, optics);
  const double cloudy = limb_filter(column_, optics, 0),
               clear = limb_filter(column_, optics, column_.cloud_top_m);
  const std::size_t rays = tangent_heights_m_.size();
  Fan fan{tangent_heights_m_,
          std::vector<double>(rays),
          std::vector<double>(rays),
          std::vector<double>(rays),
          {}};
  for (std::size_t i = 0; i < rays; ++i) {
    const double h = tangent_heights_m_[i];
    fan.impact_height_m[i] =
        h + atmosphere::refractivity(column_, optics, h) * (earth_radius_m_ + h);
    for (std::size_t k = 0; k < shares.size(); ++k) {
      fan.bending_rad[i] += shares[k] * paths_[k][i].bending_rad;
      fan.optical_depth[i] += shares[k] * atmosphere::product(paths_[k][i].amounts, spectra);
    }
    if (i > 0) fan.filter.push_back(h <= column_.cloud_top_m ? cloudy : clear);
  }
  return fan;
}

}  // namespace coppermoon::photons
