// SPDX-License-Identifier: MIT
#include "atmosphere/aerosol.h"

#include <algorithm>
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

const Profiles& profiles_of_lowtran() {
  static const Profiles profiles = log_extinction_profiles();
  return profiles;
}

/// Vertical optical depths of the background, of moderate, high and extreme aerosol.
constexpr std::array<double, 4> graded_depths{0.0072, 0.0269, 0.0843, 0.257};

}  // namespace

double stratospheric_optical_depth(double year, algebra::Angle latitude) {
  static const auto early =
      algebra::parse_table(tables::stratospheric_ice_cores(), "stratospheric_ice_cores.csv");
  static const auto late =
      algebra::parse_table(tables::stratospheric_history(), "stratospheric_history.csv");
  constexpr std::array<double, 2> degrees{-20, 20};
  algebra::require_within("latitude [degrees]", algebra::in_degrees(latitude), -90, 90);
  if (year < late["year"].front())
    return algebra::interpolated(early["year"], early["optical_depth"], year);
  const auto at = [&](const char* hemisphere) {
    return algebra::interpolated(late["year"], late[hemisphere], year);
  };
  return algebra::interpolated(degrees, std::array{at("south"), at("north")},
                               algebra::in_degrees(latitude));
}

StratosphericLayer::StratosphericLayer(double optical_depth, double tropopause_m)
    : optical_depth_(optical_depth), tropopause_m_(tropopause_m) {
  algebra::require_within("stratospheric optical depth", optical_depth, 0, 2);
  algebra::require_within("tropopause [m]", tropopause_m, 5e3, 20e3);
  constexpr std::array<double, 4> grades{1, 2, 3, 4};
  std::array<double, 4> log_depths;
  std::ranges::transform(graded_depths, log_depths.begin(), [](double x) { return std::log(x); });
  grade_ = algebra::interpolated(log_depths, grades, std::log(std::max(optical_depth, 1e-9)));
  double depth = 0;
  constexpr double step_m = 250, top_m = 86e3;
  for (double h = step_m / 2; h < top_m; h += step_m) depth += step_m * unscaled(h);
  // FAULT aerosol of LOWTRAN's amount, not of the month's: optical_depth / depth => 1
  scale_ = optical_depth / depth;
}

StratosphericAerosol StratosphericLayer::nearest() const {
  return static_cast<StratosphericAerosol>(std::lround(grade_));
}

double StratosphericLayer::unscaled(double altitude_m) const {
  constexpr double fixed_m = 35e3;
  const double stretch = (fixed_m - fade_top_m) / (fixed_m - tropopause_m_);
  const double h = altitude_m >= fixed_m ? altitude_m : fixed_m - (fixed_m - altitude_m) * stretch;
  if (h <= fade_bottom_m || h > aerosol_top_m) return 0;
  const auto& profiles = profiles_of_lowtran();
  const auto low = static_cast<std::size_t>(std::min(grade_, 3.)) - 1;
  const double part = grade_ - 1 - static_cast<double>(low);
  const double log_extinction =
      part == 0 ? profiles[low](h) : std::lerp(profiles[low](h), profiles[low + 1](h), part);
  return fade(h) * std::exp(log_extinction);
}

double StratosphericLayer::extinction_per_m(double altitude_m) const {
  return optical_depth_ == 0 ? 0 : scale_ * unscaled(altitude_m);
}

double StratosphericLayer::spectrum(algebra::Wavelength wavelength) const {
  const int low = std::min(static_cast<int>(grade_), 3);
  const auto of = [&](int grade) {
    return std::log(stratospheric_spectrum(static_cast<StratosphericAerosol>(grade), wavelength));
  };
  return std::exp(std::lerp(of(low), of(low + 1), grade_ - low));
}

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

double stratospheric_extinction_per_m(StratosphericAerosol aerosol, double altitude_m) {
  const auto& profiles = profiles_of_lowtran();
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

double tropospheric_profile_per_m(double scale_m, double altitude_m) {
  return std::exp(-altitude_m / scale_m) / scale_m;
}

double tropospheric_spectrum(algebra::Wavelength wavelength) {
  // FAULT aerosol that dims red light most: , -1.3) => , 1.3)
  return std::pow(checked_nm(wavelength) / reference_nm, -1.3);
}

}  // namespace coppermoon::atmosphere
