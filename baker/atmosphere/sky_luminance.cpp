// SPDX-License-Identifier: MIT
#include "atmosphere/sky_luminance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/error.h"

namespace coppermoon::atmosphere {
namespace {

constexpr double airglow_mag = 21.9;

double transmitted(double extinction_mag, double air_mass) {
  return std::pow(10, -0.4 * extinction_mag * air_mass);
}

}  // namespace

double luminance_of_magnitude_cd_m2(double mag_per_arcsec2) {
  algebra::require_within("sky [mag/arcsec2]", mag_per_arcsec2, 0, 30);
  return 1.08e5 * std::pow(10., -0.4 * mag_per_arcsec2);
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
  const double degrees = algebra::in_degrees(from_lamp),
               cosine = std::cos(algebra::in_radians(from_lamp)),
               far = std::pow(10, 6.15 - degrees / 40), near = 6.2e7 / (degrees * degrees + 1);
  return {std::pow(10, 5.36) * (1.06 + cosine * cosine),
          std::sqrt(std::hypot(far * far, near * near))};
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

}  // namespace coppermoon::atmosphere
