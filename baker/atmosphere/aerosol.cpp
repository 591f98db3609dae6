// SPDX-License-Identifier: MIT
#include "atmosphere/aerosol.h"

#include <array>
#include <cmath>
#include <vector>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "atmosphere/refractivity.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

constexpr double fade_bottom_m = 9e3, fade_top_m = 11e3, aerosol_top_m = 100e3;
constexpr double reference_nm = 550;

std::vector<double> logarithms(std::vector<double> values, double unit) {
  for (double& value : values) value = std::log(value * unit);
  return values;
}

using Profiles = std::array<algebra::MonotoneCubic, 4>;

Profiles log_extinction_profiles() {
  const auto table =
      algebra::parse_table(tables::stratospheric_aerosol(), "stratospheric_aerosol.csv");
  auto altitude_m = table["altitude_km"];
  for (double& h : altitude_m) h *= 1e3;
  const auto profile = [&](const char* aerosol) {
    return algebra::MonotoneCubic(altitude_m, logarithms(table[aerosol], 1e-3));
  };
  return {profile("background"), profile("moderate"), profile("high"), profile("extreme")};
}

double fade(double altitude_m) {
  if (altitude_m >= fade_top_m) return 1;
  const double t = (altitude_m - fade_bottom_m) / (fade_top_m - fade_bottom_m);
  return t * t * (3 - 2 * t);
}

const char* spectrum_of(StratosphericAerosol aerosol) {
  switch (aerosol) {
    case StratosphericAerosol::moderate:
    case StratosphericAerosol::high:
      return "aged_volcanic";
    case StratosphericAerosol::extreme:
      return "fresh_volcanic";
    default:
      return "background";
  }
}

double checked_nm(algebra::Wavelength wavelength) {
  const double nm = algebra::in_nanometres(wavelength);
  algebra::require_within("wavelength [nm]", nm, shortest_nm, longest_nm);
  return nm;
}

}  // namespace

double stratospheric_extinction_per_m(StratosphericAerosol aerosol, double altitude_m) {
  static const Profiles profiles = log_extinction_profiles();
  if (aerosol == StratosphericAerosol::none) return 0;
  if (altitude_m <= fade_bottom_m || altitude_m > aerosol_top_m) return 0;
  const auto& log_extinction = profiles[static_cast<std::size_t>(aerosol) - 1];
  return fade(altitude_m) * std::exp(log_extinction(altitude_m));
}

double stratospheric_spectrum(StratosphericAerosol aerosol, algebra::Wavelength wavelength) {
  static const auto table = algebra::parse_table(tables::stratospheric_aerosol_spectrum(),
                                                 "stratospheric_aerosol_spectrum.csv");
  const double nm = checked_nm(wavelength);
  if (aerosol == StratosphericAerosol::none) return 1;
  return std::exp(algebra::interpolated(logarithms(table["wavelength_nm"], 1),
                                        logarithms(table[spectrum_of(aerosol)], 1), std::log(nm)));
}

double tropospheric_profile_per_m(double altitude_m) {
  return std::exp(-altitude_m / tropospheric_scale_height_m) / tropospheric_scale_height_m;
}

double tropospheric_spectrum(algebra::Wavelength wavelength) {
  return std::pow(checked_nm(wavelength) / reference_nm, -1.3);
}

}  // namespace coppermoon::atmosphere
