// SPDX-License-Identifier: MIT
#include "atmosphere/air_mass.h"

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "atmosphere/astronomical_refraction.h"

namespace coppermoon::atmosphere {
namespace {

void require_altitude(algebra::Angle altitude, double lowest_deg) {
  algebra::require_within("altitude [degrees]", algebra::in_degrees(altitude), lowest_deg, 90);
}

}  // namespace

double air_mass_young_1994(algebra::Angle altitude) {
  require_altitude(altitude, -1);
  const double c = std::sin(algebra::in_radians(std::max(altitude, lowest_true_altitude)));
  return (1.002432 * c * c + 0.148386 * c + 0.0096467) /
         (c * c * c + 0.149864 * c * c + 0.0102963 * c + 0.000303978);
}

double aerosol_air_mass_schaefer_1993(algebra::Angle apparent_altitude) {
  require_altitude(apparent_altitude, 0);
  const double c = std::sin(algebra::in_radians(apparent_altitude));
  return 1 / (c + 0.0123 * std::exp(-24.5 * c));
}

double ozone_air_mass(algebra::Angle apparent_altitude) {
  require_altitude(apparent_altitude, 0);
  constexpr double earth_radius_m = 6378e3, layer_m = 22e3;
  const double sine = earth_radius_m / (earth_radius_m + layer_m) *
                      std::cos(algebra::in_radians(apparent_altitude));
  return 1 / std::sqrt(1 - sine * sine);
}

}  // namespace coppermoon::atmosphere
