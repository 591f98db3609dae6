// SPDX-License-Identifier: MIT
#include "atmosphere/gases.h"

#include <cmath>

#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "atmosphere/refractivity.h"
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

double nitrogen_dioxide_per_m3(double altitude_m) {
  static const auto log_density = log_nitrogen_dioxide();
  return std::exp(log_density(std::max(0., altitude_m)));
}

}  // namespace coppermoon::atmosphere
