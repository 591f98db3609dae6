// SPDX-License-Identifier: MIT
#include "atmosphere/sky_luminance.h"

#include <array>
#include <cmath>
#include <numbers>

#include "algebra/error.h"

namespace coppermoon::atmosphere {
namespace {

struct Piece {
  double from_degrees;
  std::array<double, 4> coefficients;  ///< of log10 of illuminance [lx]
};

/// Pieces of the fit, from the horizon down; each holds from its altitude up to that of the piece before it.
constexpr std::array pieces{
    Piece{-0.8, {2.88, 22.26, -207.64, 1034.30}},
    Piece{-5, {2.88, 21.81, -258.11, -858.36}},
    Piece{-12, {2.70, 12.17, -431.69, -1899.83}},
    Piece{-18, {13.84, 262.72, 1447.42, 2797.93}},
};

double twilight_lx(double altitude_degrees) {
  for (const auto& [from, c] : pieces)
    if (altitude_degrees >= from) {
      const double x = altitude_degrees / 90;
      return std::pow(10., c[0] + x * (c[1] + x * (c[2] + x * c[3])));
    }
  return 0;
}

}  // namespace

double luminance_of_magnitude_cd_m2(double mag_per_arcsec2) {
  algebra::require_within("sky [mag/arcsec2]", mag_per_arcsec2, 0, 30);
  return 1.08e5 * std::pow(10., -0.4 * mag_per_arcsec2);
}

double sky_luminance_cd_m2(algebra::Angle sun_altitude) {
  const double degrees = algebra::in_degrees(sun_altitude);
  algebra::require_within("altitude of the Sun [degrees]", degrees, -90, 5);
  constexpr double airglow_mag = 21.9, of_the_zenith = 0.6;
  return of_the_zenith * twilight_lx(degrees) / std::numbers::pi +
         luminance_of_magnitude_cd_m2(airglow_mag);
}

}  // namespace coppermoon::atmosphere
