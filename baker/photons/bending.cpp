// SPDX-License-Identifier: MIT
#include "photons/bending.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "algebra/quadrature.h"
#include "atmosphere/density.h"

namespace coppermoon::photons {
namespace {

using atmosphere::Column;
using atmosphere::Optics;

constexpr int nodes_a_piece = 16;

/// One column of air at one wavelength, seen along altitude.
struct Air {
  double earth_radius_m;
  const Column& column;
  const Optics& optics;

  double refractivity(double h) const { return atmosphere::refractivity(column, optics, h); }
  /// (n − 1) r
  double optical_excess(double h) const { return refractivity(h) * (earth_radius_m + h); }
  /// n r − R
  double optical_height(double h) const { return h + optical_excess(h); }
};

/// The altitude where n r = b: bisection to the last digit, for n r rises all the way.
double tangent_height(const Air& air, double impact_height_m, double top_m) {
  constexpr int halvings = 64;
  double low = -2e4, high = top_m;
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::midpoint(low, high);
    (air.optical_height(middle) < impact_height_m ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

/// A break just above the tangent height leaves the integrand all but singular there: no later
/// piece may end more than four times as far along √(r − r_t) as it begins.
std::vector<double> with_short_pieces_first(std::vector<double> breaks) {
  constexpr double longest = 16;
  const double bottom_m = breaks.front(), top_m = breaks.back();
  for (double d = longest * (breaks[1] - bottom_m); bottom_m + d < top_m; d *= longest)
    breaks.push_back(bottom_m + d);
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

/// The altitudes between which the air is smooth and no piece is longer than 8 km, from `bottom_m`
/// up.
std::vector<double> pieces_above(double bottom_m, const Column& column, double top_m) {
  std::vector<double> breaks{bottom_m, column.dust_bottom_m, column.dust_top_m, top_m};
  for (const double h : atmosphere::density_breaks_m()) breaks.push_back(h);
  for (double h = 8e3; h < top_m; h += 8e3) breaks.push_back(h);
  std::sort(breaks.begin(), breaks.end());
  constexpr double rounding_m =
      1e-4;  // a break closer above the tangent height than that drowns in it
  std::erase_if(breaks, [&](double h) {
    return h != bottom_m && h != top_m && (h < bottom_m + rounding_m || h > top_m);
  });
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks.size() > 2 ? with_short_pieces_first(std::move(breaks)) : breaks;
}

struct Sums {
  double bending = 0, rayleigh_m = 0, dust_m = 0;
};

/// Half a ray, from one altitude to the next above the tangent height.
void add_piece(const Air& air, double tangent_m, double from_m, double to_m, Sums& sums) {
  const double u0 = std::sqrt(from_m - tangent_m), u1 = std::sqrt(to_m - tangent_m);
  const double b = air.earth_radius_m + air.optical_height(tangent_m);
  const double at_tangent = air.optical_excess(tangent_m);
  const double middle = (from_m + to_m) / 2;
  const bool dusty = middle >= air.column.dust_bottom_m && middle < air.column.dust_top_m;
  const double scale = air.column.refraction ? air.optics.refractivity : 0;
  for (const auto& [x, weight] : algebra::gauss_legendre(nodes_a_piece)) {
    const double u = (u0 + u1) / 2 + (u1 - u0) / 2 * x, h = tangent_m + u * u;
    const auto density = atmosphere::density_ratio_and_slope_yapo_cutler(h);
    const double r = air.earth_radius_m + h, n = 1 + scale * density.value;
    const double excess = u * u + (scale * density.value * r - at_tangent);  // n r − b
    const double dh = weight * (u1 - u0) / 2 * 2 * u;
    const double root = std::sqrt(excess * (n * r + b));
    sums.bending -= 2 * b * scale * density.slope_per_m / (n * root) * dh;
    sums.rayleigh_m += 2 * density.value * n * r / root * dh;
    if (dusty) sums.dust_m += 2 * n * r / root * dh;
  }
}

}  // namespace

std::optional<LimbRay> limb_ray(double impact_height_m, const atmosphere::Atmosphere& atmosphere,
                                const Column& column, const Optics& optics) {
  algebra::require_within("impact height [m]", impact_height_m, -1e4, atmosphere.top_m);
  const Air air{atmosphere.earth_radius_m, column, optics};
  const double tangent_m = tangent_height(air, impact_height_m, atmosphere.top_m);
  if (tangent_m < 0) return std::nullopt;
  Sums sums;
  const auto breaks = pieces_above(tangent_m, column, atmosphere.top_m);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    add_piece(air, tangent_m, breaks[i], breaks[i + 1], sums);
  const double optical_depth = (column.rayleigh ? optics.rayleigh_per_m * sums.rayleigh_m : 0) +
                               column.dust_extinction_per_m * sums.dust_m;
  return LimbRay{tangent_m, sums.bending,
                 std::exp(-optical_depth) * ozone_transmittance(column, optics), optical_depth};
}

}  // namespace coppermoon::photons
