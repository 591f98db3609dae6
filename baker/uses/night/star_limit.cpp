// SPDX-License-Identifier: MIT
#include "uses/night/star_limit.h"

#include <cmath>

#include "atmosphere/sky_luminance.h"

namespace coppermoon::uses {

double faintest_star(double sky_cd_m2) {
  const double zero_point = atmosphere::luminance_of_magnitude_cd_m2(0),
               magnitude = -2.5 * std::log10(sky_cd_m2 / zero_point);
  return 7.93 - 5 * std::log10(1 + std::pow(10, 4.316 - magnitude / 5));
}

}  // namespace coppermoon::uses
