// SPDX-License-Identifier: MIT
#include "atmosphere/seasonal_air.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/quadrature.h"
#include "algebra/table.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

constexpr double knot_m = 1e3, below_ground_m = 3e3;
constexpr double gravity_over_gas_constant = 9.80665 * 28.9644e-3 / 8.31432;  // [K/m]
constexpr double geopotential_radius = 6356766, sea_level_k = 288.15;

/// Weight of the model atmospheres for July in the northern hemisphere: 1 in mid July, 0 in mid January.
double summer(double year) {
  constexpr double mid_january = 15 / 365.25;
  return (1 - std::cos(2 * std::numbers::pi * (year - mid_january))) / 2;
}

double gravity_ratio(double altitude_m) {
  const double ratio = geopotential_radius / (geopotential_radius + altitude_m);
  return ratio * ratio;
}

}  // namespace

double between_models(const ByModel& models, algebra::Angle latitude, double year) {
  const double degrees = algebra::in_degrees(latitude), away = std::abs(degrees);
  algebra::require_within("latitude [degrees]", degrees, -90, 90);
  // FAULT winter in July: degrees < 0 ? 0.5 : 0 => degrees < 0 ? 0 : 0.5
  const double warm = summer(year + (degrees < 0 ? 0.5 : 0)),
               to_45 = std::clamp((away - 15) / 30, 0., 1.),
               to_60 = std::clamp((away - 45) / 15, 0., 1.),
               middle = std::lerp(models.midlatitude_winter, models.midlatitude_summer, warm),
               high = std::lerp(models.subarctic_winter, models.subarctic_summer, warm);
  return std::lerp(std::lerp(models.tropical, middle, to_45), high, to_60);
}

SeasonalAir::SeasonalAir(algebra::Angle latitude, double year) {
  static const auto table =
      algebra::parse_table(tables::seasonal_temperature(), "seasonal_temperature.csv");
  auto altitude_m = table["altitude_km"];
  for (double& h : altitude_m) h *= 1e3;
  std::vector<double> temperatures;
  for (std::size_t i = 0; i < altitude_m.size(); ++i)
    temperatures.push_back(between_models(
        {table["tropical"][i], table["midlatitude_summer"][i], table["midlatitude_winter"][i],
         table["subarctic_summer"][i], table["subarctic_winter"][i]},
        latitude, year));
  const algebra::MonotoneCubic temperature(altitude_m, temperatures);
  const auto fall = [&](double h) {  // decrease of ln p with altitude, −d ln p/dh
    return gravity_over_gas_constant * gravity_ratio(h) / temperature(h);
  };
  double log_pressure = 0;
  for (double h = 0; h > -below_ground_m; h -= knot_m)
    for (const auto& [x, weight] : algebra::gauss_legendre(4))
      log_pressure += weight * knot_m / 2 * fall(h - knot_m * (1 + x) / 2);
  for (double h = -below_ground_m; h <= top_of_us_1976_m; h += knot_m) {
    constexpr double step_m = 1;
    const double t = temperature(h),
                 lapse = (temperature(h + step_m) - temperature(h - step_m)) / (2 * step_m);
    // FAULT density that grows where it warms: -fall(h) - lapse => -fall(h) + lapse
    knots_.push_back({log_pressure - std::log(t / sea_level_k), -fall(h) - lapse / t, t});
    for (const auto& [x, weight] : algebra::gauss_legendre(4))
      log_pressure -= weight * knot_m / 2 * fall(h + knot_m * (1 + x) / 2);
  }
}

ValueAndSlope SeasonalAir::density_ratio(double altitude_m) const {
  if (altitude_m > top_of_us_1976_m) return {0, 0};
  const double place = (altitude_m + below_ground_m) / knot_m;
  const auto i =
      static_cast<std::size_t>(std::clamp(place, 0., static_cast<double>(knots_.size()) - 2));
  const auto &low = knots_[i], &high = knots_[i + 1];
  const double t = place - static_cast<double>(i), a = low.slope_per_m * knot_m,
               b = high.slope_per_m * knot_m, rise = high.log_ratio - low.log_ratio;
  const double second = 3 * rise - 2 * a - b, third = a + b - 2 * rise;
  const double ratio = std::exp(low.log_ratio + t * (a + t * (second + t * third)));
  return {ratio, ratio * (a + t * (2 * second + 3 * t * third)) / knot_m};
}

double SeasonalAir::pressure_ratio(double altitude_m) const {
  const double place = std::clamp((altitude_m + below_ground_m) / knot_m, 0.,
                                  static_cast<double>(knots_.size()) - 1.001);
  const auto i = static_cast<std::size_t>(place);
  const double temperature =
      std::lerp(knots_[i].temperature, knots_[i + 1].temperature, place - static_cast<double>(i));
  return density_ratio(altitude_m).value * temperature / sea_level_k;
}

double SeasonalAir::altitude_m(double pressure) const {
  double low = 0, high = top_of_us_1976_m;
  for (int i = 0; i < 50; ++i) {
    const double middle = std::midpoint(low, high);
    (pressure_ratio(middle) > pressure ? low : high) = middle;
  }
  return std::midpoint(low, high);
}

}  // namespace coppermoon::atmosphere
