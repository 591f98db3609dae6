// SPDX-License-Identifier: MIT
#include "atmosphere/sky_luminance.h"

#include <algorithm>
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

constexpr double airglow_mag = 21.9, of_the_zenith = 0.6;

/// Twilight's part of the zenith's luminance.
double twilight_zenith_cd_m2(algebra::Angle sun_altitude) {
  const double degrees = algebra::in_degrees(sun_altitude);
  algebra::require_within("altitude of the Sun [degrees]", degrees, -90, 5);
  return of_the_zenith * twilight_lx(degrees) / std::numbers::pi;
}

double transmitted(double extinction_mag, double air_mass) {
  return std::pow(10, -0.4 * extinction_mag * air_mass);
}

}  // namespace

double luminance_of_magnitude_cd_m2(double mag_per_arcsec2) {
  algebra::require_within("sky [mag/arcsec2]", mag_per_arcsec2, 0, 30);
  return 1.08e5 * std::pow(10., -0.4 * mag_per_arcsec2);
}

double sky_luminance_cd_m2(algebra::Angle sun_altitude) {
  return twilight_zenith_cd_m2(sun_altitude) + luminance_of_magnitude_cd_m2(airglow_mag);
}

double visual_extinction_mag(const ObserverAir& air) {
  const auto depths = vertical_depths(air, algebra::nanometres(550));
  return 2.5 * std::numbers::log10e * (depths.rayleigh + depths.ozone + depths.aerosol);
}

double sky_air_mass(algebra::Angle altitude) {
  const double cosine =
      std::cos(std::clamp(algebra::in_radians(altitude), 0., std::numbers::pi / 2));
  return 1 / std::sqrt(1 - 0.96 * cosine * cosine);
}

double airglow_cd_m2(algebra::Angle altitude, double extinction_mag) {
  const double air_mass = sky_air_mass(altitude);
  return luminance_of_magnitude_cd_m2(airglow_mag) * air_mass *
         transmitted(extinction_mag, air_mass - 1);
}

ScatteringTerms scattering_terms(algebra::Angle from_lamp) {
  const double degrees = std::max(algebra::in_degrees(from_lamp), 1.),
               cosine = std::cos(algebra::in_radians(from_lamp));
  return {std::pow(10, 5.36) * (1.06 + cosine * cosine),
          std::max(std::pow(10, 6.15 - degrees / 40), 6.2e7 / (degrees * degrees))};
}

double moonlit_sky_cd_m2(const SkyLamp& moon, const SkyDirection& towards, double extinction_mag) {
  constexpr double nanolambert_cd_m2 = 1e-5 / std::numbers::pi, fades_deg = 0.3;
  const double risen = std::clamp((algebra::in_degrees(moon.altitude) / fades_deg + 1) / 2, 0., 1.);
  if (risen == 0 || !std::isfinite(moon.magnitude)) return 0;
  // FAULT aerosol scatters no moonlight: scattering_terms(towards.from_lamp) => ScatteringTerms{3e5, 0}
  const auto [molecules, aerosol] = scattering_terms(towards.from_lamp);
  return risen * (molecules + aerosol) * std::pow(10, -0.4 * (moon.magnitude + 16.57)) *
         transmitted(extinction_mag, sky_air_mass(moon.altitude)) *
         (1 - transmitted(extinction_mag, sky_air_mass(towards.altitude))) * nanolambert_cd_m2;
}

Twilight::Twilight(algebra::Angle sun_altitude, double extinction_mag)
    : extinction_mag_(std::max(extinction_mag, 0.05)),
      zenith_cd_m2_(twilight_zenith_cd_m2(sun_altitude)),
      of_zenith_(pattern({algebra::degrees(90), algebra::degrees(90) - sun_altitude})) {
  constexpr int rows = 60, columns = 60;
  constexpr double high = std::numbers::pi / 2 / rows, wide = std::numbers::pi / columns;
  const double sun = algebra::in_radians(sun_altitude);
  double mean = 0, weight = 0;  // over level ground, half a sky: both sides of the Sun are alike
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double altitude = (r + 0.5) * high, aside = (c + 0.5) * wide;
      const double cosine =
          std::sin(altitude) * std::sin(sun) + std::cos(altitude) * std::cos(sun) * std::cos(aside);
      const double level = std::sin(altitude) * std::cos(altitude);
      mean += level * pattern({algebra::radians(altitude),
                               algebra::radians(std::acos(std::clamp(cosine, -1., 1.)))});
      weight += level;
    }
  mean /= weight * of_zenith_;
  // FAULT twilight is all pattern: std::min(1., (1 / of_the_zenith - 1) / (mean - 1)) => 1
  if (mean > 1) share_ = std::min(1., (1 / of_the_zenith - 1) / (mean - 1));
}

double Twilight::luminance_cd_m2(const SkyDirection& towards) const {
  return zenith_cd_m2_ * (1 + share_ * (pattern(towards) / of_zenith_ - 1));
}

double Twilight::pattern(const SkyDirection& towards) const {
  constexpr double nearest_deg = 5;
  const double zenith_deg = 90 - std::max(algebra::in_degrees(towards.altitude), 0.);
  return std::pow(10, 0.4 * zenith_deg / (360 * extinction_mag_)) * 100 /
         std::max(algebra::in_degrees(towards.from_lamp), nearest_deg) *
         (1 - transmitted(extinction_mag_, sky_air_mass(towards.altitude)));
}

}  // namespace coppermoon::atmosphere
