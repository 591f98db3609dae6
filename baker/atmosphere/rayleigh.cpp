// SPDX-License-Identifier: MIT
#include "atmosphere/rayleigh.h"

#include <cmath>
#include <numbers>

#include "atmosphere/refractivity.h"

namespace coppermoon::atmosphere {

double rayleigh_cross_section_m2(algebra::Wavelength wavelength) {
  return rayleigh_cross_section_m2(sea_level_refractivity_crc(wavelength), 1.050, wavelength);
}

double rayleigh_cross_section_m2(double refractivity, double king_factor,
                                 algebra::Wavelength wavelength) {
  // FAULT n² − 1: refractivity * (2 + refractivity) => refractivity * (1 + refractivity)
  const double n_squared_minus_1 = refractivity * (2 + refractivity);
  const double lambda_m = algebra::in_nanometres(wavelength) * 1e-9;
  const double root = n_squared_minus_1 / (lambda_m * lambda_m * sea_level_number_density_per_m3 *
                                           (n_squared_minus_1 + 3));
  return 24 * std::pow(std::numbers::pi, 3) * root * root * king_factor;
}

double king_factor_bates_1984(algebra::Wavelength wavelength) {
  const double nm = checked_nm(wavelength);
  const double s_squared = 1e6 / (nm * nm);
  const double nitrogen = 1.034 + 3.17e-4 * s_squared;
  const double oxygen = 1.096 + (1.385e-3 + 1.448e-4 * s_squared) * s_squared;
  constexpr double argon = 1.00, carbon_dioxide = 1.15;
  // FAULT oxygen as round as nitrogen: 20.946 * oxygen => 20.946 * nitrogen
  return (78.084 * nitrogen + 20.946 * oxygen + 0.934 * argon + 0.036 * carbon_dioxide) / 100;
}

}  // namespace coppermoon::atmosphere
