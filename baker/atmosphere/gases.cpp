// SPDX-License-Identifier: MIT
#include "atmosphere/gases.h"

#include <cmath>

#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "atmosphere/refractivity.h"
#include "atmosphere/seasonal_air.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

algebra::MonotoneCubic log_nitrogen_dioxide() {
  const auto table =
      algebra::parse_table(tables::nitrogen_dioxide_profile(), "nitrogen_dioxide_profile.csv");
  auto altitude_m = table["altitude_km"], log_density = table["number_density_per_m3"];
  for (double& h : altitude_m) h *= 1e3;
  for (double& n : log_density) n = std::log(n);
  return {altitude_m, log_density};
}

double band_per_m(const char* gas, algebra::Wavelength wavelength) {
  static const auto table = algebra::parse_table(tables::gas_bands(), "gas_bands.csv");
  return algebra::interpolated(table["wavelength_nm"], table[gas], checked_nm(wavelength));
}

}  // namespace

double oxygen_pair_cross_section_m5(algebra::Wavelength wavelength) {
  static const auto table = algebra::parse_table(tables::oxygen_pairs(), "oxygen_pairs.csv");
  return algebra::interpolated(table["wavelength_nm"], table["cross_section_m5"],
                               checked_nm(wavelength));
}

double nitrogen_dioxide_cross_section_m2(algebra::Wavelength wavelength) {
  static const auto table =
      algebra::parse_table(tables::nitrogen_dioxide(), "nitrogen_dioxide.csv");
  return algebra::interpolated(table["wavelength_nm"], table["cross_section_m2"],
                               checked_nm(wavelength));
}

double oxygen_bands_per_m(algebra::Wavelength wavelength) {
  return band_per_m("oxygen_per_m", wavelength);
}

double water_vapour_per_m(double water, algebra::Wavelength wavelength) {
  return std::pow(water, 0.62) * band_per_m("water_per_m", wavelength);
}

double water_vapour_profile(double altitude_m) {
  const double h_km = altitude_m / 1e3;
  return std::exp(-h_km / 4 - std::pow(h_km / 8.3, 2));
}

double seasonal_water(algebra::Angle latitude, double year) {
  constexpr ByModel ppm{3346, 2225, 824.1, 2218, 430.3};
  constexpr double us_1976_ppm = 1397;
  return between_models(ppm, latitude, year) / us_1976_ppm;
}

double nitrogen_dioxide_per_m3(double altitude_m) {
  static const auto log_density = log_nitrogen_dioxide();
  return std::exp(log_density(std::max(0., altitude_m)));
}

}  // namespace coppermoon::atmosphere
