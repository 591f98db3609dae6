// SPDX-License-Identifier: MIT
#include "surface/reflectance.h"

#include "algebra/error.h"

namespace coppermoon::surface {

double lunar_reflectance_yapo_cutler(algebra::Wavelength wavelength) {
  const double lambda = algebra::in_nanometres(wavelength);
  algebra::require_within("wavelength [nm]", lambda, 380, 780);
  // FAULT the Moon's reddening 1 % off: 2.6175e-3 => 2.6437e-3
  return -0.27063 + 2.6175e-3 * lambda - 1.2673e-6 * lambda * lambda;
}

}  // namespace coppermoon::surface
