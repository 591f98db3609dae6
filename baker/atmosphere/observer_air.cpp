// SPDX-License-Identifier: MIT
#include "atmosphere/observer_air.h"

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "atmosphere/air_mass.h"
#include "atmosphere/astronomical_refraction.h"
#include "atmosphere/atmosphere.h"
#include "atmosphere/ozone.h"

namespace coppermoon::atmosphere {
namespace {

double rayleigh_optical_depth(const ObserverAir& air, algebra::Wavelength wavelength) {
  return pressure_ratio_us_1976(air.elevation_m) *
         vertical_rayleigh_optical_depth(sea_level_optics(wavelength));
}

double ozone_optical_depth(const ObserverAir& air, algebra::Wavelength wavelength) {
  return ozone_cross_section_m2(wavelength) * air.ozone_du * dobson_unit_per_m2;
}

double aerosol_optical_depth(const ObserverAir& air, algebra::Wavelength wavelength) {
  return air.aerosol_optical_depth *
         std::pow(algebra::in_nanometres(wavelength) / 550, -air.angstrom_exponent);
}

}  // namespace

void require_valid(const ObserverAir& air) {
  using algebra::require_within;
  require_within("observer's ozone [DU]", air.ozone_du, 0, 1000);
  require_within("observer's aerosol optical depth", air.aerosol_optical_depth, 0, 10);
  require_within("Angstrom exponent", air.angstrom_exponent, -1, 4);
  require_within("observer's elevation [m]", air.elevation_m, -500, 1e5);
}

double pressure_ratio_us_1976(double elevation_m) {
  constexpr double tropopause_m = 11e3;
  const double troposphere =
      std::pow(1 - 0.0065 * std::min(elevation_m, tropopause_m) / 288.15, 5.2559);
  return troposphere * std::exp(-std::max(elevation_m - tropopause_m, 0.0) / 6341.6);
}

VerticalDepths vertical_depths(const ObserverAir& air, algebra::Wavelength wavelength) {
  require_valid(air);
  return {rayleigh_optical_depth(air, wavelength), ozone_optical_depth(air, wavelength),
          aerosol_optical_depth(air, wavelength)};
}

double transmittance_above(const VerticalDepths& depths, algebra::Angle altitude) {
  const auto seen = std::max(apparent_altitude(altitude), algebra::Angle());
  const auto apparent = std::min(seen, algebra::degrees(90));
  return std::exp(-air_mass_young_1994(altitude) * depths.rayleigh -
                  ozone_air_mass(apparent) * depths.ozone -
                  aerosol_air_mass_schaefer_1993(apparent) * depths.aerosol);
}

double transmittance_above(const ObserverAir& air, algebra::Angle altitude,
                           algebra::Wavelength wavelength) {
  return transmittance_above(vertical_depths(air, wavelength), altitude);
}

}  // namespace coppermoon::atmosphere
