// SPDX-License-Identifier: MIT
#include "photons/bending.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "algebra/quadrature.h"

namespace coppermoon::photons {
namespace {

using atmosphere::Column;
using atmosphere::Optics;

/// Properties of a column of air at one wavelength, as functions of altitude.
struct Air {
  double earth_radius_m;
  const Column& column;
  double refractivity;

  /// Optical excess (n − 1) r: the amount by which n r exceeds the distance r from the Earth's centre [m].
  double optical_excess(double h) const {
    return refractivity * atmosphere::density_ratio(column, h).value * (earth_radius_m + h);
  }
  /// Optical height n r − R, with the ground's radius R. At a ray's tangent point it equals b − R.
  double optical_height(double h) const { return h + optical_excess(h); }
};

/// Altitude of the tangent point, where n r = b, by bisection to the last digit. n r always increases with altitude.
double tangent_height(const Air& air, double impact_height_m, double top_m) {
  constexpr int halvings = 64;
  double low = 0, high = top_m;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(low, high);
    (air.optical_height(middle) < impact_height_m ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

/// Inserts further altitudes between those given, because the integrand is nearly singular just above the tangent
/// radius r_t. Afterwards, √(r − r_t) grows by a factor of at most four within every interval but the first.
std::vector<double> with_short_pieces_first(std::vector<double> breaks) {
  constexpr double longest = 16;
  const double bottom_m = breaks.front(), top_m = breaks.back();
  for (double d = longest * (breaks[1] - bottom_m); bottom_m + d < top_m; d *= longest)
    breaks.push_back(bottom_m + d);
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

/// Altitude below which the profiles of seasonal air (air given by month) have kinks at whole kilometres.
constexpr double knees_below_m = 32e3;

/// Altitudes, at most 8 km apart, that divide the air above `bottom_m` into pieces in which its profiles are smooth.
std::vector<double> pieces_above(double bottom_m, const Column& column, double top_m) {
  constexpr double knees_apart_m = 1e3, longest_m = 8e3;
  std::vector<double> breaks = atmosphere::breaks_m(column);
  breaks.insert(breaks.end(), {bottom_m, top_m});
  for (double h = longest_m; h < top_m; h += longest_m) breaks.push_back(h);
  if (column.seasonal_air)
    for (double h = knees_apart_m; h < knees_below_m; h += knees_apart_m) breaks.push_back(h);
  std::sort(breaks.begin(), breaks.end());
  constexpr double rounding_m = 1e-11;  // closer altitudes differ only by rounding errors
  std::erase_if(breaks, [&](double h) {
    return h != bottom_m && h != top_m && (h < bottom_m + rounding_m || h > top_m);
  });
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks.size() > 2 ? with_short_pieces_first(std::move(breaks)) : breaks;
}

/// Range of altitudes in which the profiles of the air are smooth.
struct Piece {
  double from_m, to_m;
};

/// Node of the quadrature over altitude, with the properties of the air there.
struct Node {
  double above_m, r_m, dh_m;  ///< height above tangent, geocentric distance, quadrature weight
  atmosphere::ValueAndSlope density;
  atmosphere::Amounts profiles;
};

/// One half of a ray, from its tangent point upwards.
struct HalfRay {
  Air air;
  LimbPath path;
  double at_tangent = air.optical_excess(path.tangent_height_m);
  /// n r − b, with b the impact parameter, at the lower end of the current piece if close to the tangent point [m].
  double over_b_m = 0;

  /// Height above the tangent point below which n r − b is not found by subtraction, which would lose most digits.
  static constexpr double close_m = 1e-4;

  /// The difference n r − b. Close to the tangent point, it is found from the piece's lower end and the slope of n r.
  double over_b(const Piece& piece, double above_m, const atmosphere::ValueAndSlope& density,
                double r) const {
    if (above_m > close_m) return above_m + (air.refractivity * density.value * r - at_tangent);
    const double slope = 1 + air.refractivity * (density.value + density.slope_per_m * r);
    return over_b_m + (above_m - (piece.from_m - path.tangent_height_m)) * slope;
  }

  void add(const Piece& piece, const Node& node) {
    const double b = air.earth_radius_m + path.impact_height_m, r = node.r_m, dh = node.dh_m;
    const double n = 1 + air.refractivity * node.density.value;
    const double root = std::sqrt(over_b(piece, node.above_m, node.density, r) * (n * r + b));
    // FAULT bending 1 % too large: path.bending_rad -= 2 * b => path.bending_rad -= 2.02 * b
    path.bending_rad -= 2 * b * air.refractivity * node.density.slope_per_m / (n * root) * dh;
    // FAULT an amount along the path without the refractive index: 2 * n * r => 2 * r
    const double along_m = 2 * n * r / root * dh;
    for (std::size_t k = 0; k < node.profiles.size(); ++k)
      path.amounts[k] += node.profiles[k] * along_m;
  }

  void end(const Piece& piece) {
    const double above_m = piece.to_m - path.tangent_height_m;
    if (above_m > close_m) return;
    const double h = std::midpoint(piece.from_m, piece.to_m);  // not an end, where slopes may jump
    over_b_m =
        over_b(piece, above_m, atmosphere::density_ratio(air.column, h), air.earth_radius_m + h);
  }
};

/// Number of quadrature nodes for a piece of a ray's path.
int nodes_of(const Piece& piece, const Column& column) {
  constexpr int a_piece = 16, above_knees = 10, between_knees = 3;
  if (!column.seasonal_air) return a_piece;
  return piece.to_m <= knees_below_m ? between_knees : above_knees;
}

constexpr double row_m = 25;

}  // namespace

ProfileTable::ProfileTable(const Column& column) : column_(column) {
  const double top_m = atmosphere::top_m(column);
  for (double h = 0; h < top_m + row_m; h += row_m)
    rows_.push_back(atmosphere::profiles(column_, std::min(h, top_m)));
}

atmosphere::Amounts ProfileTable::operator()(double altitude_m) const {
  const double place = std::max(0., altitude_m) / row_m;
  const auto i = std::min(static_cast<std::size_t>(place), rows_.size() - 2);
  const double along = place - static_cast<double>(i);
  atmosphere::Amounts amounts;
  for (std::size_t k = 0; k < amounts.size(); ++k)
    amounts[k] = rows_[i][k] + along * (rows_[i + 1][k] - rows_[i][k]);
  amounts[atmosphere::dust_layer] =
      atmosphere::profile(column_, atmosphere::dust_layer, altitude_m);
  return amounts;
}

std::vector<LimbPath> limb_paths(double tangent_height_m, double earth_radius_m,
                                 const Column& column, std::span<const double> refractivities,
                                 const ProfileTable* table) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  algebra::require_within("tangent height [m]", tangent_height_m, 0, infinity);
  std::vector<HalfRay> rays;
  for (const double refractivity : refractivities) {
    atmosphere::require_no_trap(column, earth_radius_m, refractivity);
    const Air air{earth_radius_m, column, column.refraction ? refractivity : 0};
    rays.push_back({air, {tangent_height_m, air.optical_height(tangent_height_m), 0, {}}});
  }
  const double top_m = atmosphere::top_m(column);
  if (tangent_height_m < top_m) {
    const auto breaks = pieces_above(tangent_height_m, column, top_m);
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      const Piece piece{breaks[i], breaks[i + 1]};
      const double u0 = std::sqrt(piece.from_m - tangent_height_m),
                   u1 = std::sqrt(piece.to_m - tangent_height_m);
      for (const auto& [x, weight] : algebra::gauss_legendre(nodes_of(piece, column))) {
        const double u = (u0 + u1) / 2 + (u1 - u0) / 2 * x, h = tangent_height_m + u * u;
        const Node node{u * u, earth_radius_m + h, weight * (u1 - u0) / 2 * 2 * u,
                        atmosphere::density_ratio(column, h),
                        table ? (*table)(h) : atmosphere::profiles(column, h)};
        for (auto& ray : rays) ray.add(piece, node);
      }
      for (auto& ray : rays) ray.end(piece);
    }
  }
  std::vector<LimbPath> paths;
  for (const auto& ray : rays) paths.push_back(ray.path);
  return paths;
}

LimbPath limb_path(double tangent_height_m, double earth_radius_m, const Column& column,
                   double refractivity, const ProfileTable* table) {
  return limb_paths(tangent_height_m, earth_radius_m, column, std::span(&refractivity, 1), table)
      .front();
}

std::optional<LimbRay> limb_ray(double impact_height_m, double earth_radius_m, const Column& column,
                                const Optics& optics) {
  const double top = atmosphere::top_m(column);
  algebra::require_within("impact height [m]", impact_height_m, -1e4, top);
  const Air air{earth_radius_m, column, column.refraction ? optics.refractivity : 0};
  atmosphere::require_no_trap(column, earth_radius_m, optics.refractivity);
  if (impact_height_m < air.optical_height(0)) return std::nullopt;
  const double tangent_m = tangent_height(air, impact_height_m, top);
  const auto path = limb_path(tangent_m, earth_radius_m, column, optics.refractivity);
  const double optical_depth =
      atmosphere::product(path.amounts, atmosphere::spectra(column, optics));
  return LimbRay{tangent_m, path.bending_rad,
                 std::exp(-optical_depth) * limb_filter(column, optics, tangent_m), optical_depth};
}

}  // namespace coppermoon::photons
