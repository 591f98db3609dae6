// SPDX-License-Identifier: MIT
#include "atmosphere/refractivity.h"

#include "algebra/error.h"

namespace coppermoon::atmosphere {

double sea_level_refractivity_crc(algebra::Wavelength wavelength) {
  const double nm = algebra::in_nanometres(wavelength);
  algebra::require_within("wavelength [nm]", nm, shortest_nm, longest_nm);
  const double s = 1 / (nm * nm);
  return 2.72643e-4 + 1.2288 * s + 3.555e4 * s * s;
}

}  // namespace coppermoon::atmosphere
