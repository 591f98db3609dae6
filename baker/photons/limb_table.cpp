// SPDX-License-Identifier: MIT
#include "photons/limb_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "algebra/error.h"
#include "algebra/interpolation.h"

namespace coppermoon::photons {
namespace {

using atmosphere::Column;
using atmosphere::Optics;

/// Number of values that describe a ray's path: its bending and the amounts of absorbers along it.
constexpr std::size_t parts_of_path = 1 + std::tuple_size_v<atmosphere::Amounts>;
using Path = std::array<double, parts_of_path>;

Path parts(const LimbPath& path) {
  Path all{path.bending_rad};
  std::copy(path.amounts.begin(), path.amounts.end(), all.begin() + 1);
  return all;
}

LimbPath path_of(double tangent_height_m, const Path& all) {
  LimbPath path{tangent_height_m, 0, all[0], {}};
  std::copy(all.begin() + 1, all.end(), path.amounts.begin());
  return path;
}

/// Tangent heights at which a fan must have rays: ground, breaks of profiles, tops of cloud, column and all air.
std::vector<double> stations(const Column& column, double top_m) {
  auto heights = atmosphere::breaks_m(column);
  heights.insert(heights.end(), {0, std::max(top_m, heights.back())});
  if (column.cloud_cover > 0) heights.push_back(column.cloud_top_m);
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

/// Interval of tangent heights in which the slopes of the profiles do not jump.
struct HeightRange {
  double low_m, high_m;

  /// Tangent height at a place in the interval.
  ///
  /// Given  place  from 0 at the lower end to 1 at the upper end, linear in √(high − h)
  double height_m(double place) const {
    return high_m - (high_m - low_m) * (1 - place) * (1 - place);
  }
};

/// The j-th Chebyshev point on [0, 1] for a polynomial of the given degree. The points decrease from 1 to 0.
double chebyshev_place(int j, int degree) {
  return (1 + std::cos(std::numbers::pi * j / degree)) / 2;
}

/// Polynomial that passes through given values at the Chebyshev points.
class Polynomial {
 public:
  explicit Polynomial(std::vector<Path> values) : values_(std::move(values)) {
    const int degree = static_cast<int>(values_.size()) - 1;
    for (int j = 0; j <= degree; ++j) {
      places_.push_back(chebyshev_place(j, degree));
      // FAULT one end of Chebyshev's points counts whole: j == 0 || j == degree => j == 0
      const bool end = j == 0 || j == degree;
      weights_.push_back((j % 2 == 0 ? 1 : -1) * (end ? 0.5 : 1));
    }
  }

  /// Value of the polynomial, by the barycentric formula of Berrut & Trefethen (2004), SIAM Review 46, 501.
  Path operator()(double place) const {
    Path sum{};
    double total = 0;
    for (std::size_t j = 0; j < values_.size(); ++j) {
      const double away = place - places_[j];
      if (std::abs(away) < 1e-14) return values_[j];
      const double share = weights_[j] / away;
      total += share;
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += share * values_[j][k];
    }
    for (double& value : sum) value /= total;
    return sum;
  }

 private:
  std::vector<Path> values_;
  std::vector<double> places_, weights_;
};

/// Chebyshev nodes between two refractivities; a single node if the two are equal.
std::vector<double> chebyshev_roots(double least, double greatest, int count) {
  if (!(greatest - least > 1e-9 * greatest)) return {greatest};
  const double middle = (least + greatest) / 2, half = (greatest - least) / 2;
  std::vector<double> roots;
  for (int i = 0; i < count; ++i)
    roots.push_back(middle - half * std::cos(std::numbers::pi * (i + 0.5) / count));
  return roots;
}

/// Measures how much the difference between two paths matters. Bending counts in milliradians, because one milliradian
/// shifts a ray at the Moon by the distance over which light changes by a factor e. Differences in optical depth count
/// as they are, or less if the transmittance is small.
class Significance {
 public:
  Significance(const Column& column, const Optics& optics)
      : spectra_(atmosphere::spectra(column, optics)) {}

  double of(const Path& path, const Path& other) const {
    constexpr double milliradian = 1e-3, deep = 4;
    double depth = 0, difference = 0;
    for (std::size_t k = 0; k < spectra_.size(); ++k) {
      depth += spectra_[k] * path[k + 1];
      difference += spectra_[k] * (path[k + 1] - other[k + 1]);
    }
    return std::max(std::abs(path[0] - other[0]) / milliradian,
                    std::abs(difference) / std::max(1., depth / deep));
  }

 private:
  atmosphere::Amounts spectra_;
};

/// Paths of rays at the Chebyshev points of a range of heights, indexed by [refractivity][point].
using Points = std::vector<std::vector<Path>>;

/// Traces rays through one column of air.
struct Follower {
  const Column& column;
  double earth_radius_m;
  std::span<const double> refractivities;
  /// Table of profiles, used only for seasonal air, whose many smooth terms are slow to evaluate.
  std::optional<ProfileTable> table =
      column.seasonal_air ? std::optional<ProfileTable>(column) : std::nullopt;

  /// Paths of rays at the Chebyshev points for a polynomial of the given degree.
  ///
  /// Given  known  paths at every second point, already traced for half the degree; may be empty
  Points at(const HeightRange& piece, int degree, const Points& known = {}) const {
    const auto count = static_cast<std::size_t>(degree) + 1;
    Points values(refractivities.size(), std::vector<Path>(count));
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t j) {
      if (!known.empty() && j % 2 == 0) {
        for (std::size_t k = 0; k < values.size(); ++k) values[k][j] = known[k][j / 2];
        return;
      }
      const double place = chebyshev_place(static_cast<int>(j), degree);
      const auto paths = limb_paths(piece.height_m(place), earth_radius_m, column, refractivities,
                                    table ? &*table : nullptr);
      for (std::size_t k = 0; k < values.size(); ++k) values[k][j] = parts(paths[k]);
    });
    return values;
  }

  /// Paths of rays at the Chebyshev points for a polynomial of sufficient degree. The degree is doubled until half the
  /// degree suffices to predict the paths at the greatest refractivity to within the tolerance.
  Points sufficient(const HeightRange& piece, const Significance& significance,
                    double error) const {
    constexpr int lowest = 6, highest = 48;
    // doubling the degree reduces the error by this factor or more, even for profiles with kinks
    constexpr double gain = 16;
    auto coarse = at(piece, lowest);
    for (int degree = 2 * lowest; degree <= highest; degree *= 2) {
      auto fine = at(piece, degree, coarse);
      if (degree == highest) return fine;
      const Polynomial half(coarse.back());
      double worst = 0;
      for (int j = 1; j < degree; j += 2)
        worst = std::max(worst, significance.of(fine.back()[static_cast<std::size_t>(j)],
                                                half(chebyshev_place(j, degree))));
      if (worst <= error) return coarse;
      if (worst <= gain * error) return fine;
      coarse = std::move(fine);
    }
    return coarse;
  }
};

/// Largest second difference of the paths in an interval, scaled to its whole length. It estimates the error of linear
/// interpolation across the undivided interval.
double unevenness(const Polynomial& path, const Significance& significance) {
  constexpr int cuts = 16;
  double worst = 0;
  for (int i = 1; i < cuts; ++i) {
    const double place = static_cast<double>(i) / cuts, step = 1. / cuts;
    const auto here = path(place), before = path(place - step), after = path(place + step);
    Path middle;
    for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = (before[k] + after[k]) / 2;
    worst = std::max(worst, significance.of(here, middle));
  }
  return worst * cuts * cuts;
}

/// Number of rays for each interval: at least four, in proportion to √unevenness, because this minimises the error.
std::vector<int> shares_of_rays(std::span<const double> unevenness, int rays) {
  double all = 0;
  for (const double u : unevenness) all += std::sqrt(u);
  std::vector<int> shares;
  for (const double u : unevenness)
    shares.push_back(2 *
                     std::max(2, static_cast<int>(rays / 2 * (all > 0 ? std::sqrt(u) / all : 0))));
  return shares;
}

std::vector<HeightRange> pieces_of(const Column& column, double top_m) {
  const auto ends = stations(column, top_m);
  std::vector<HeightRange> pieces;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) pieces.push_back({ends[i], ends[i + 1]});
  return pieces;
}

}  // namespace

std::vector<double> refractivity_nodes(const Column& column, std::span<const Optics> optics,
                                       int count) {
  if (!column.refraction) return {0};
  const auto [least, greatest] = std::ranges::minmax(optics, {}, &Optics::refractivity);
  return chebyshev_roots(least.refractivity, greatest.refractivity, count);
}

Blend blend(const Column& column, const Optics& optics, std::span<const double> nodes) {
  Blend blend{column.refraction ? optics.refractivity : 0,
              algebra::on_polynomial(nodes, optics.refractivity),
              {},
              limb_filter(column, optics, 0),
              limb_filter(column, optics, column.cloud_top_m)};
  for (const double share : blend.shares) {
    blend.extinction.push_back(atmosphere::spectra(column, optics));
    for (double& extinction : blend.extinction.back()) extinction *= share;
  }
  return blend;
}

atmosphere::ValueAndSlope optical_excess_m(const Column& column, double earth_radius_m,
                                           double tangent_height_m) {
  const auto density = atmosphere::density_ratio(column, tangent_height_m);
  const double r = earth_radius_m + tangent_height_m;
  return {density.value * r, density.slope_per_m * r + density.value};
}

LimbTable::LimbTable(const Column& column, double earth_radius_m, std::span<const Optics> optics,
                     int rays, double top_m) {
  const double error = 10. / rays / rays;
  const auto greatest = std::ranges::max(optics, {}, &Optics::refractivity);
  const int nodes = error < 3e-5 ? 4 : 3;
  refractivities_ = refractivity_nodes(column, optics, nodes);
  const Follower follower{column, earth_radius_m, refractivities_};
  const Significance significance(column, greatest);
  const auto pieces = pieces_of(column, top_m);
  std::vector<std::vector<Polynomial>> polynomials(refractivities_.size());
  std::vector<double> uneven;
  for (const auto& piece : pieces) {
    auto points = follower.sufficient(piece, significance, error);
    followed_ += points.size() * points.back().size();
    for (std::size_t k = 0; k < points.size(); ++k)
      polynomials[k].emplace_back(std::move(points[k]));
    uneven.push_back(unevenness(polynomials.back().back(), significance));
  }
  const auto shares = shares_of_rays(uneven, rays);
  paths_.resize(refractivities_.size());
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (int i = 0; i < shares[p] + (p + 1 == pieces.size() ? 1 : 0); ++i) {
      const double place = static_cast<double>(i) / shares[p], h = pieces[p].height_m(place);
      tangent_heights_m_.push_back(h);
      optical_excess_m_.push_back(optical_excess_m(column, earth_radius_m, h).value);
      for (std::size_t k = 0; k < paths_.size(); ++k)
        paths_[k].push_back(path_of(h, polynomials[k][p](place)));
    }
}

Fan LimbTable::fan(const Optics& optics, const Column& column) const {
  const auto wave = blend(column, optics, refractivities_);
  const std::size_t rays = tangent_heights_m_.size();
  Fan fan{tangent_heights_m_,
          std::vector<double>(rays),
          std::vector<double>(rays),
          std::vector<double>(rays),
          {}};
  for (std::size_t i = 0; i < rays; ++i) {
    const double h = tangent_heights_m_[i];
    fan.impact_height_m[i] = h + wave.refractivity * optical_excess_m_[i];
    for (std::size_t k = 0; k < wave.shares.size(); ++k) {
      fan.bending_rad[i] += wave.shares[k] * paths_[k][i].bending_rad;
      fan.optical_depth[i] += atmosphere::product(paths_[k][i].amounts, wave.extinction[k]);
    }
    // FAULT cloud above its top: wave.cloudy : wave.clear => wave.clear : wave.cloudy
    if (i > 0) fan.filter.push_back(h <= column.cloud_top_m ? wave.cloudy : wave.clear);
  }
  return fan;
}

}  // namespace coppermoon::photons
