// SPDX-License-Identifier: MIT
#include "atmosphere/ozone.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/quadrature.h"
#include "algebra/table.h"
#include "atmosphere/refractivity.h"
#include "atmosphere/tables.h"
#include "atmosphere/tropopause.h"

namespace coppermoon::atmosphere {
namespace {

double column(const algebra::MonotoneCubic& log_density, const std::vector<double>& altitude_m) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < altitude_m.size(); ++i) {
    const double middle = (altitude_m[i] + altitude_m[i + 1]) / 2, half = middle - altitude_m[i];
    for (const auto& node : algebra::gauss_legendre(20))
      // FAULT the ozone column 1 % off: half * node.weight * => 1.01 * half * node.weight *
      sum += half * node.weight * std::exp(log_density(middle + half * node.x));
  }
  return sum;
}

struct OzoneProfile {
  algebra::MonotoneCubic log_share_per_m;
  double top_m;
};

OzoneProfile standard_ozone() {
  const auto table = algebra::parse_table(tables::ozone_profile(), "ozone_profile.csv");
  auto altitude_m = table["altitude_km"], log_density = table["number_density_per_m3"];
  for (double& h : altitude_m) h *= 1e3;
  for (double& n : log_density) n = std::log(n);
  const double log_column = std::log(column({altitude_m, log_density}, altitude_m));
  for (double& n : log_density) n -= log_column;
  return {{altitude_m, log_density}, altitude_m.back()};
}

constexpr int months = 12, layers = 30;
constexpr double layer_km = 2;

/// Ozone in each layer over a latitude in one month [DU].
std::vector<double> layers_of_month(const algebra::Table& table, int month, double latitude_deg) {
  const auto& latitudes = table["latitude_degrees"];
  const auto belts = latitudes.size() / months, first = static_cast<std::size_t>(month) * belts;
  std::vector<double> southward(latitudes.begin(),
                                latitudes.begin() + static_cast<std::ptrdiff_t>(belts));
  for (double& latitude : southward) latitude = -latitude;
  std::vector<double> du;
  for (int i = 0; i < layers; ++i)
    du.push_back(algebra::interpolated(
        southward,
        std::span(table["du_" + std::to_string(static_cast<int>(layer_km) * i) + "_km"])
            .subspan(first, belts),
        -latitude_deg));
  return du;
}

std::vector<double> layers_of(double latitude_deg, double year) {
  static const auto table =
      algebra::parse_table(tables::ozone_climatology(), "ozone_climatology.csv");
  const auto month = season_share(year, months, 0.5 / months);
  auto du = layers_of_month(table, month.before, latitude_deg);
  const auto after = layers_of_month(table, month.after, latitude_deg);
  for (std::size_t i = 0; i < du.size(); ++i) du[i] = std::lerp(du[i], after[i], month.share_after);
  return du;
}

/// Altitude [m] for a pressure altitude, which is 16 km log10(p₀/p) at pressure p; 0 if p is higher than at the ground.
double altitude_m(const SeasonalAir& air, double pressure_altitude_km) {
  return air.altitude_m(std::pow(10, -pressure_altitude_km / 16));
}

/// Logarithm of the share of the ozone column per metre: a curve through the middles of the layers, linear above them.
algebra::MonotoneCubic log_shares(std::span<const double> du, const SeasonalAir& air) {
  std::vector<double> middle_m, log_share;
  for (int i = 0; i < layers; ++i) {
    const double from_m = altitude_m(air, layer_km * i), to_m = altitude_m(air, layer_km * (i + 1));
    middle_m.push_back((from_m + to_m) / 2);
    log_share.push_back(std::log(du[static_cast<std::size_t>(i)] / (to_m - from_m)));
  }
  const std::size_t last = middle_m.size() - 1;
  const double slope =
      (log_share[last] - log_share[last - 5]) / (middle_m[last] - middle_m[last - 5]);
  middle_m.insert(middle_m.begin(), 0);
  log_share.insert(log_share.begin(), log_share.front());
  log_share.push_back(log_share.back() + slope * (top_of_us_1976_m - middle_m.back()));
  middle_m.push_back(top_of_us_1976_m);
  const double log_column = std::log(column({middle_m, log_share}, middle_m));
  for (double& share : log_share) share -= log_column;
  return {middle_m, log_share};
}

}  // namespace

OzoneClimate::OzoneClimate(algebra::Angle latitude, double year, const SeasonalAir& air)
    : column_du_(0), log_share_per_m_([&] {
        const double degrees = algebra::in_degrees(latitude);
        algebra::require_within("latitude [degrees]", degrees, -90, 90);
        const auto du = layers_of(degrees, year);
        column_du_ = std::reduce(du.begin(), du.end());
        return log_shares(du, air);
      }()) {}

double OzoneClimate::profile_per_m(double altitude_m) const {
  return altitude_m > top_of_us_1976_m ? 0 : std::exp(log_share_per_m_(std::max(0., altitude_m)));
}

double ozone_cross_section_m2(algebra::Wavelength wavelength) {
  static const auto table =
      algebra::parse_table(tables::ozone_cross_section(), "ozone_cross_section.csv");
  return algebra::interpolated(table["wavelength_nm"], table["cross_section_m2"],
                               checked_nm(wavelength));
}

double ozone_profile_per_m(double altitude_m) {
  static const auto ozone = standard_ozone();
  return altitude_m > ozone.top_m ? 0 : std::exp(ozone.log_share_per_m(altitude_m));
}

double ozone_filter_yapo_cutler(algebra::Wavelength wavelength, double dobson_units) {
  algebra::require_within("ozone [DU]", dobson_units, 0, 1000);
  return std::exp(-grazing_ozone_air_mass * ozone_cross_section_m2(wavelength) * dobson_units *
                  dobson_unit_per_m2);
}

}  // namespace coppermoon::atmosphere
