// SPDX-License-Identifier: MIT
#include "atmosphere/air_mass.h"

#include <cmath>

#include "algebra/error.h"

namespace coppermoon::atmosphere {

double air_mass_young_1994(algebra::Angle altitude) {
  algebra::require_within("altitude [degrees]", algebra::in_degrees(altitude), 0, 90);
  const double c = std::sin(algebra::in_radians(altitude));
  return (1.002432 * c * c + 0.148386 * c + 0.0096467) /
         (c * c * c + 0.149864 * c * c + 0.0102963 * c + 0.000303978);
}

}  // namespace coppermoon::atmosphere
