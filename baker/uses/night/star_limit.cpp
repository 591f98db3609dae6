// SPDX-License-Identifier: MIT
#include "uses/night/star_limit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "atmosphere/sky_luminance.h"

namespace coppermoon::uses {

double moonlit_sky_cd_m2(double moon_magnitude, algebra::Angle moon_altitude) {
  const double altitude_deg = algebra::in_degrees(moon_altitude);
  if (altitude_deg <= 0 || !std::isfinite(moon_magnitude)) return 0;
  constexpr double k = 0.172, nanolambert_cd_m2 = 1e-5 / std::numbers::pi;
  const double rho_deg = 90 - altitude_deg, cosine = std::sin(algebra::in_radians(moon_altitude)),
               sine = std::cos(algebra::in_radians(moon_altitude));
  const double f = std::pow(10, 5.36) * (1.06 + cosine * cosine) +
                   std::pow(10, 6.15 - rho_deg / 40),
               air_masses = 1 / std::sqrt(1 - 0.96 * sine * sine),
               light = std::pow(10, -0.4 * (moon_magnitude + 16.57));
  return f * light * std::pow(10, -0.4 * k * air_masses) * (1 - std::pow(10, -0.4 * k)) *
         nanolambert_cd_m2;
}

double faintest_star(double sky_cd_m2) {
  const double zero_point = atmosphere::luminance_of_magnitude_cd_m2(0),
               magnitude = -2.5 * std::log10(sky_cd_m2 / zero_point);
  return 7.93 - 5 * std::log10(1 + std::pow(10, 4.316 - magnitude / 5));
}

}  // namespace coppermoon::uses
