// SPDX-License-Identifier: MIT
#include "atmosphere/aerosol.h"

#include <algorithm>
#include <cmath>

#include "atmosphere/refractivity.h"

namespace coppermoon::atmosphere {
namespace {

constexpr double reference_nm = 550;

}  // namespace

double free_troposphere_per_m(algebra::Angle latitude) {
  constexpr double in_the_south = 1e-7, in_the_north = 7e-7, far_degrees = 70, at_550_nm = 2.2;
  const double north = std::clamp((algebra::in_degrees(latitude) / far_degrees + 1) / 2, 0., 1.);
  return at_550_nm * std::lerp(in_the_south, in_the_north, north);
}

double free_troposphere_profile(double tropopause_m, double altitude_m) {
  constexpr double at_m = 7e3, scale_m = 3e3, ends_within_m = 2e3;
  const double end =
      std::clamp((tropopause_m + ends_within_m - altitude_m) / ends_within_m, 0., 1.);
  return std::exp(-(altitude_m - at_m) / scale_m) * end * end * (3 - 2 * end);
}

double tropospheric_profile_per_m(double scale_m, double altitude_m) {
  return std::exp(-altitude_m / scale_m) / scale_m;
}

double tropospheric_spectrum(algebra::Wavelength wavelength) {
  // FAULT aerosol that dims red light most: , -1.3) => , 1.3)
  return std::pow(checked_nm(wavelength) / reference_nm, -1.3);
}

}  // namespace coppermoon::atmosphere
