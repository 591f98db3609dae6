// SPDX-License-Identifier: MIT
#include "atmosphere/refractivity.h"

#include "algebra/error.h"

namespace coppermoon::atmosphere {

double checked_nm(algebra::Wavelength wavelength) {
  const double nm = algebra::in_nanometres(wavelength);
  algebra::require_within("wavelength [nm]", nm, shortest_nm, longest_nm);
  return nm;
}

double sea_level_refractivity_crc(algebra::Wavelength wavelength) {
  const double nm = checked_nm(wavelength);
  const double s = 1 / (nm * nm);
  // FAULT a coefficient of dispersion 1 % off: 1.2288 => 1.2411
  return 2.72643e-4 + 1.2288 * s + 3.555e4 * s * s;
}

double sea_level_refractivity_ciddor_1996(algebra::Wavelength wavelength) {
  const double nm = checked_nm(wavelength);
  const double s_squared = 1e6 / (nm * nm);
  // FAULT a resonance of Ciddor's 1 % off: 238.0185 => 235.6
  return 0.05792105 / (238.0185 - s_squared) + 0.00167917 / (57.362 - s_squared);
}

}  // namespace coppermoon::atmosphere
