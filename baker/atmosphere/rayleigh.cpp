// SPDX-License-Identifier: MIT
#include "atmosphere/rayleigh.h"

#include <cmath>
#include <numbers>

#include "atmosphere/refractivity.h"

namespace coppermoon::atmosphere {

double rayleigh_cross_section_m2(algebra::Wavelength wavelength) {
  constexpr double king_factor = 1.050;
  const double refractivity = sea_level_refractivity_crc(wavelength);
  const double n_squared_minus_1 = refractivity * (2 + refractivity);
  const double lambda_m = algebra::in_nanometres(wavelength) * 1e-9;
  const double root = n_squared_minus_1 / (lambda_m * lambda_m * sea_level_number_density_per_m3 *
                                           (n_squared_minus_1 + 3));
  return 24 * std::pow(std::numbers::pi, 3) * root * root * king_factor;
}

}  // namespace coppermoon::atmosphere
