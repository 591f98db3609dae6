// SPDX-License-Identifier: MIT
#include "atmosphere/atmosphere.h"

#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "algebra/quadrature.h"
#include "atmosphere/density.h"
#include "atmosphere/ozone.h"
#include "atmosphere/rayleigh.h"
#include "atmosphere/refractivity.h"

namespace coppermoon::atmosphere {
namespace {

/// Turned by whole circles into [0, 2π).
double turned(double angle_rad) {
  const double circle = 2 * std::numbers::pi;
  const double rest = std::fmod(angle_rad, circle);
  return rest < 0 ? rest + circle : rest;
}

void require_valid(const Column& column) {
  algebra::require_within("ozone [DU]", column.ozone_du, 0, 1000);
  algebra::require_within("dust extinction [1/m]", column.dust_extinction_per_m, 0, 0.01);
  algebra::require_within("dust bottom [m]", column.dust_bottom_m, 0, taper_top_m);
  algebra::require_within("dust top [m]", column.dust_top_m, column.dust_bottom_m, taper_top_m);
}

}  // namespace

const Column& Atmosphere::column_at(double position_angle_rad) const {
  for (const auto& region : regions) {
    const double from = algebra::in_radians(region.from),
                 width = algebra::in_radians(region.to) - from;
    const bool whole = width >= 2 * std::numbers::pi;
    if (whole || turned(position_angle_rad - from) < turned(width)) return region.column;
  }
  return column;
}

void require_valid(const Atmosphere& atmosphere) {
  algebra::require_within("Earth's radius [m]", atmosphere.earth_radius_m, 1e6, 1e7);
  algebra::require_within("top of the air [m]", atmosphere.top_m, 0, taper_top_m);
  require_valid(atmosphere.column);
  for (const auto& region : atmosphere.regions) require_valid(region.column);
}

Optics sea_level_optics(algebra::Wavelength wavelength) {
  return {sea_level_refractivity_crc(wavelength),
          rayleigh_cross_section_m2(wavelength) * sea_level_number_density_per_m3,
          algebra::in_nanometres(wavelength)};
}

double refractivity(const Column& column, const Optics& optics, double altitude_m) {
  return column.refraction ? optics.refractivity * density_ratio_yapo_cutler(altitude_m) : 0;
}

double extinction_per_m(const Column& column, const Optics& optics, double altitude_m) {
  const double rayleigh =
      column.rayleigh ? optics.rayleigh_per_m * density_ratio_yapo_cutler(altitude_m) : 0;
  const bool dusty = altitude_m >= column.dust_bottom_m && altitude_m < column.dust_top_m;
  return dusty ? rayleigh + column.dust_extinction_per_m : rayleigh;
}

double ozone_transmittance(const Column& column, const Optics& optics) {
  return column.ozone_du > 0
             ? ozone_filter_yapo_cutler(algebra::nanometres(optics.wavelength_nm), column.ozone_du)
             : 1;
}

double vertical_rayleigh_optical_depth(const Optics& optics) {
  constexpr int pieces = 20;
  constexpr double piece_m = taper_top_m / pieces;
  double column_m = 0;
  for (int i = 0; i < pieces; ++i)
    for (const auto& [x, weight] : algebra::gauss_legendre(8))
      column_m += weight * piece_m / 2 * density_ratio_yapo_cutler((i + (1 + x) / 2) * piece_m);
  return optics.rayleigh_per_m * column_m;
}

}  // namespace coppermoon::atmosphere
