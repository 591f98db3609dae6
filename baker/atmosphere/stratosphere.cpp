// SPDX-License-Identifier: MIT
#include "atmosphere/stratosphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "algebra/table.h"
#include "atmosphere/cloud.h"
#include "atmosphere/refractivity.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

constexpr double fade_bottom_m = 9e3, fade_top_m = 11e3, aerosol_top_m = 100e3;

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
  return smooth_step((altitude_m - fade_bottom_m) / (fade_top_m - fade_bottom_m));
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

/// Vertical optical depths of background, moderate, high and extreme aerosol.
constexpr std::array<double, 4> graded_depths{0.0072, 0.0269, 0.0843, 0.257};
constexpr std::array<double, 4> grades{1, 2, 3, 4};

/// Position of an optical depth on a scale of LOWTRAN's aerosols, from 1 (background) to 4 (extreme).
double grade_of_depth(double optical_depth) {
  std::array<double, 4> log_depths;
  std::ranges::transform(graded_depths, log_depths.begin(), [](double x) { return std::log(x); });
  return algebra::interpolated(log_depths, grades, std::log(std::max(optical_depth, 1e-9)));
}

const algebra::Table& spectra_of_lowtran() {
  static const auto table = algebra::parse_table(tables::stratospheric_aerosol_spectrum(),
                                                 "stratospheric_aerosol_spectrum.csv");
  return table;
}

/// Position of an Ångström exponent on a scale of LOWTRAN's spectra, from 1 (background) to 4 (extreme).
double grade_of_exponent(double exponent) {
  const auto& table = spectra_of_lowtran();
  const auto& nm = table["wavelength_nm"];
  const auto of = [&](const char* name) {  // Ångström exponent between 550 and 1060 nm
    // FAULT small particles taken for large ones: return -std::log => return std::log
    return -std::log(table[name][3] / table[name][1]) / std::log(nm[3] / nm[1]);
  };
  const std::array<double, 3> exponents{of("fresh_volcanic"), of("aged_volcanic"),
                                        of("background")};
  constexpr std::array<double, 3> at{4, 2.5, 1};
  return algebra::interpolated(exponents, at, exponent);
}

constexpr double first_of_bands = 1979, lowest_recorded_m = 8e3, highest_recorded_m = 44.5e3;

/// Record of stratospheric aerosol by band of latitude and by layer (below 16 km, 16 to 20 km, above 20 km).
struct BandRecord {
  static constexpr std::array<double, 6> middles{-75, -45, -15, 15, 45, 75};
  static constexpr std::array names{"90S-60S", "60S-30S", "30S-0", "0-30N", "30N-60N", "60N-90N"};
  static constexpr std::array layers{"low_", "middle_", "high_"};
  algebra::Table months, shapes;

  double at(const std::string& column, double year) const {
    return algebra::interpolated(months["year"], months[column], year);
  }

  double depth(std::size_t band, double year) const {
    double sum = 0;
    for (const auto* layer : layers) sum += at(std::string(layer) + names[band], year);
    return sum;
  }

  /// Interpolates a value linearly to a latitude, between the middles of the two nearest bands of latitude.
  template <class Value>
  double between(algebra::Angle latitude, Value value) const {
    const auto place = algebra::on_line(middles, algebra::in_degrees(latitude));
    return std::lerp(value(place.below), value(place.above), place.further);
  }
};

const BandRecord& record() {
  static const BandRecord record{
      algebra::parse_table(tables::stratospheric_bands(), "stratospheric_bands.csv"),
      algebra::parse_table(tables::stratospheric_shapes(), "stratospheric_shapes.csv")};
  return record;
}

/// Factor that rises from 0 at 2 km below the tropopause to 1 at the tropopause.
double over_the_tropopause(double altitude_m, double tropopause_m) {
  return smooth_step((altitude_m - tropopause_m) / 2e3 + 1);
}

/// Extinction as a function of altitude, over a latitude in a month, summed over the three layers of BandRecord.
algebra::MonotoneCubic recorded_extinction(double year, algebra::Angle latitude,
                                           double tropopause_m) {
  const auto& bands = record();
  auto altitude_m = bands.shapes["altitude_km"];
  for (double& h : altitude_m) h *= 1e3;
  std::vector<double> sum(altitude_m.size(), 0.);
  for (const std::string layer : BandRecord::layers) {
    const double depth = bands.between(
        latitude, [&](std::size_t band) { return bands.at(layer + bands.names[band], year); });
    std::vector<double> profile;
    double whole = 0;
    for (std::size_t i = 0; i < altitude_m.size(); ++i) {
      const double shape = bands.between(latitude, [&](std::size_t band) {
        const auto name = layer + bands.names[band];
        return bands.shapes[name][i] * bands.at(name, year);
      });
      profile.push_back(shape * over_the_tropopause(altitude_m[i], tropopause_m));
      whole += profile.back() * (altitude_m[1] - altitude_m[0]);
    }
    for (std::size_t i = 0; whole > 0 && i < sum.size(); ++i) sum[i] += profile[i] * depth / whole;
  }
  altitude_m.push_back(altitude_m.back() + 5e3);
  sum.push_back(0);
  return {altitude_m, sum};
}

void require_latitude(algebra::Angle latitude) {
  algebra::require_within("latitude [degrees]", algebra::in_degrees(latitude), -90, 90);
}

}  // namespace

double stratospheric_optical_depth(double year, algebra::Angle latitude) {
  static const auto early =
      algebra::parse_table(tables::stratospheric_ice_cores(), "stratospheric_ice_cores.csv");
  static const auto hemispheres =
      algebra::parse_table(tables::stratospheric_history(), "stratospheric_history.csv");
  constexpr std::array<double, 2> degrees{-20, 20};
  require_latitude(latitude);
  if (year >= first_of_bands)
    return record().between(latitude, [&](std::size_t band) { return record().depth(band, year); });
  if (year < hemispheres["year"].front())
    return algebra::interpolated(early["year"], early["optical_depth"], year);
  const auto at = [&](const char* hemisphere) {
    return algebra::interpolated(hemispheres["year"], hemispheres[hemisphere], year);
  };
  return algebra::interpolated(degrees, std::array{at("south"), at("north")},
                               algebra::in_degrees(latitude));
}

double stratospheric_depth_error(double year) {
  constexpr double first_unknown = 2026, error_of_the_unknown = 0.003;
  if (year >= first_unknown) return error_of_the_unknown;
  struct Era {
    double end, error;
  };
  constexpr std::array<Era, 6> eras{
      {{1850, 0.4}, {1979, 0.3}, {2017, 0.1}, {2022, 0.15}, {2025, 0.25}, {first_unknown, 0.3}}};
  const auto era = std::ranges::find_if(eras, [&](const Era& one) { return year < one.end; });
  constexpr int parts = 6;  // number of bands of equal area
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    sum += stratospheric_optical_depth(year, algebra::radians(std::asin((2 * i + 1.) / parts - 1)));
  return era->error * sum / parts;
}

double stratospheric_exponent(double year, algebra::Angle latitude) {
  require_latitude(latitude);
  if (year < first_of_bands)
    throw algebra::Error(fmt::format("year = {}, allowed {} and later", year, first_of_bands));
  const auto& bands = record();
  return bands.between(latitude, [&](std::size_t band) {
    return bands.at(std::string("exponent_") + bands.names[band], year);
  });
}

StratosphericLayer StratosphericLayer::of_month(double year, algebra::Angle latitude,
                                                double tropopause_m) {
  StratosphericLayer layer(stratospheric_optical_depth(year, latitude), tropopause_m);
  if (year < first_of_bands) return layer;
  layer.grade_ = grade_of_exponent(stratospheric_exponent(year, latitude));
  layer.recorded_ =
      std::make_shared<algebra::MonotoneCubic>(recorded_extinction(year, latitude, tropopause_m));
  layer.normalise();
  return layer;
}

StratosphericLayer StratosphericLayer::with_optical_depth(double optical_depth) const {
  if (!recorded_) return {optical_depth, tropopause_m_};
  algebra::require_within("stratospheric optical depth", optical_depth, 0, 2);
  auto layer = *this;
  layer.optical_depth_ = optical_depth;
  layer.grade_ = grade_at(optical_depth);
  layer.normalise();
  return layer;
}

double StratosphericLayer::grade_at(double optical_depth) const {
  return std::clamp(grade_ + grade_of_depth(optical_depth) - grade_of_depth(optical_depth_), 1.,
                    4.);
}

StratosphericLayer::StratosphericLayer(double optical_depth, double tropopause_m)
    : optical_depth_(optical_depth), tropopause_m_(tropopause_m) {
  algebra::require_within("stratospheric optical depth", optical_depth, 0, 2);
  algebra::require_within("tropopause [m]", tropopause_m, 5e3, 20e3);
  grade_ = grade_of_depth(optical_depth);
  normalise();
}

void StratosphericLayer::normalise() {
  double depth = 0;
  constexpr double step_m = 250, top_m = 86e3;
  for (double h = step_m / 2; h < top_m; h += step_m) depth += step_m * unscaled(h);
  // FAULT aerosol of LOWTRAN's amount, not of the month's: optical_depth_ / depth => 1
  scale_ = optical_depth_ / depth;
}

StratosphericAerosol StratosphericLayer::nearest() const {
  return static_cast<StratosphericAerosol>(std::lround(grade_));
}

double StratosphericLayer::unscaled(double altitude_m) const {
  if (recorded_)
    return altitude_m < lowest_recorded_m || altitude_m > highest_recorded_m
               ? 0
               : (*recorded_)(altitude_m);
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

double StratosphericLayer::spectrum(algebra::Wavelength wavelength, double factor) const {
  const double place = factor == 1 ? grade_ : grade_at(factor * optical_depth_);
  const int low = std::min(static_cast<int>(place), 3);
  const auto of = [&](int grade) {
    return std::log(stratospheric_spectrum(static_cast<StratosphericAerosol>(grade), wavelength));
  };
  return std::exp(std::lerp(of(low), of(low + 1), place - low));
}

double stratospheric_extinction_per_m(StratosphericAerosol aerosol, double altitude_m) {
  const auto& profiles = profiles_of_lowtran();
  if (aerosol == StratosphericAerosol::none) return 0;
  if (altitude_m <= fade_bottom_m || altitude_m > aerosol_top_m) return 0;
  const auto& log_extinction = profiles[static_cast<std::size_t>(aerosol) - 1];
  return fade(altitude_m) * std::exp(log_extinction(altitude_m));
}

double stratospheric_spectrum(StratosphericAerosol aerosol, algebra::Wavelength wavelength) {
  const auto& table = spectra_of_lowtran();
  const double nm = checked_nm(wavelength);
  if (aerosol == StratosphericAerosol::none) return 1;
  return std::exp(algebra::interpolated(logarithms(table["wavelength_nm"], 1),
                                        logarithms(table[spectrum_of(aerosol)], 1), std::log(nm)));
}

}  // namespace coppermoon::atmosphere
