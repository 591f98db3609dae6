// SPDX-License-Identifier: MIT
#include "atmosphere/astronomical_refraction.h"

#include <algorithm>
#include <cmath>

#include "algebra/error.h"

namespace coppermoon::atmosphere {
namespace {

/// Refraction by Saemundsson's formula. The altitude may slightly exceed 90 degrees, for a disc's limb near the zenith.
algebra::Angle refraction_saemundsson_1986(algebra::Angle true_altitude) {
  const double h = std::max(algebra::in_degrees(true_altitude), -1.0);
  const double tangent = std::tan(algebra::in_radians(algebra::degrees(h + 10.3 / (h + 5.11))));
  return algebra::degrees((1.02 / tangent + 0.0019279) / 60);
}

void require_altitude(algebra::Angle altitude) {
  algebra::require_within("altitude [degrees]", algebra::in_degrees(altitude), -90, 90);
}

}  // namespace

algebra::Angle astronomical_refraction(algebra::Angle true_altitude) {
  require_altitude(true_altitude);
  return refraction_saemundsson_1986(true_altitude);
}

algebra::Angle apparent_altitude(algebra::Angle true_altitude) {
  const double seen = std::clamp(algebra::in_degrees(true_altitude) + 2, 0., 1.);
  return true_altitude + seen * astronomical_refraction(true_altitude);
}

double refracted_flattening(algebra::Angle true_altitude, algebra::Angle diameter) {
  require_altitude(true_altitude);
  algebra::require_within("diameter [degrees]", algebra::in_degrees(diameter), 1e-6, 10);
  const auto lower = refraction_saemundsson_1986(true_altitude - 0.5 * diameter);
  const auto upper = refraction_saemundsson_1986(true_altitude + 0.5 * diameter);
  return 1 - (lower - upper) / diameter;
}

}  // namespace coppermoon::atmosphere
