// SPDX-License-Identifier: MIT
#include "atmosphere/eye_contrast.h"

#include <algorithm>
#include <cmath>

namespace coppermoon::atmosphere {

double contrast_threshold(double sky_cd_m2, double solid_angle_sr) {
  constexpr double field_factor = 2, darkest_cd_m2 = 1e-5;
  const double sky = std::max(sky_cd_m2, darkest_cd_m2), lg = std::log10(sky),
               root = std::pow(sky, -0.25);
  const double of_point = sky < 0.0708 ? 6.505e-4 * root - 8.461e-4 : 1.772e-4 * root + 7.167e-5;
  const double of_field = sky < 0.354 ? 7.633e-3 * root - 7.174e-3 : 2.720e-3;
  const double q = sky < 0.193 ? 0.6 : sky < 3.40 ? 0.8861 + 0.4 * lg : 1.146 - 0.0885 * lg;
  return field_factor *
         std::pow(std::pow(of_point * of_point / solid_angle_sr, q) + std::pow(of_field, q), 1 / q);
}

}  // namespace coppermoon::atmosphere
