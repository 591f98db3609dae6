// SPDX-License-Identifier: MIT
#include "uses/fit/nuisances_of_air.h"

#include <algorithm>
#include <cmath>

#include "uses/fit/limb_weather.h"

namespace coppermoon::uses {
namespace {

/// Grid (photograph × bins + bin, channel) of ln(light in the expected air / light in another air).
algebra::Grid<double> dimming(std::span<const Binned> photographs, const NightErrors& night,
                              const NightRows& rows, const algebra::Grid<double>& other) {
  const double least = is_mixed(photographs) ? least_of_brightest : 0;
  algebra::Grid<double> all(photographs.size() * rows.bins, 3);
  for (std::size_t p = 0; p < photographs.size(); ++p)
    for (std::size_t b = 0; b < rows.bins; ++b) {
      const auto row = rows.own(p, b);
      const auto& colours = photographs[p].colours;
      const auto before = as_written(night.expected.row(row), colours, night.mixing, least),
                 after = as_written(other.row(row), colours, night.mixing, least);
      for (std::size_t k = 0; k < 3; ++k)
        all(p * rows.bins + b, k) = std::log(before[k] / after[k]);
    }
  return all;
}

/// Grid (photograph × bins + bin, channel) of how much cloud dims light, relative to the mean dimming of red light in
/// the umbra. If the fit has a factor on the chance of cloud, the values are also scaled by weather_over_usual: the
/// error due to weather, relative to typical air. The grid is empty if the effect of cloud is not known.
algebra::Grid<double> dimming_by_cloud(std::span<const Binned> photographs,
                                       const NightErrors& night, const NightRows& rows) {
  constexpr double least_distance_km = 1000, most_distance_km = 4000;
  if (night.clouded.empty()) return {};
  auto all = dimming(photographs, night, rows, night.clouded);
  double red = 0, count = 0;
  for (std::size_t p = 0; p < photographs.size(); ++p)
    for (std::size_t b = 0; b < rows.bins; ++b) {
      const double distance_km = photographs[p].scene->distances_km[b];
      if (distance_km < least_distance_km || distance_km > most_distance_km) continue;
      red += all(p * rows.bins + b, 0);
      ++count;
    }
  if (count == 0 || red <= 0) return {};
  const double mean = red / count,
               weather = night.clouded_by > 0 ? weather_over_usual(mean / night.clouded_by) : 1;
  for (double& value : all.values()) value *= weather / mean;
  return all;
}

}  // namespace

Limbs limbs_of(std::span<const Binned> photographs) {
  Limbs limbs;
  if (std::ranges::any_of(photographs,
                          [](const Binned& one) { return one.errors.weather_error > 0; }))
    for (const auto& one : photographs) limbs.push_back(limb_of_bins(*one.scene));
  return limbs;
}

Nuisance aerosol_of(std::span<const Binned> photographs, const NightErrors& night,
                    const NightRows& rows, const Limbs& limbs) {
  constexpr double over_weather = 1.5;
  if (limbs.empty() || night.dusty.empty()) return {"aerosol", SharedBy::night, 0, {}, {}};
  const auto by_aerosol = dimming(photographs, night, rows, night.dusty);
  return {"aerosol", SharedBy::night, weather_sectors,
          [=](const Measurement& m) {
            return over_weather * photographs[m.photograph].errors.weather_error;
          },
          [=, by = night.dusty_by](const Measurement& m, std::size_t sector) {
            return limbs[m.photograph](m.bin, sector) *
                   by_aerosol(m.photograph * rows.bins + m.bin, m.channel) / by;
          }};
}

Nuisance weather_of(std::span<const Binned> photographs, const NightErrors& night,
                    const NightRows& rows, const Limbs& limbs) {
  if (limbs.empty()) return {"weather", SharedBy::night, 0, {}, {}};
  std::vector<double> seconds;
  for (const auto& one : photographs)
    seconds.push_back(
        almanac::seconds_between(photographs.front().scene->sky.when, one.scene->sky.when));
  const auto changes = weather_changes(seconds);
  const auto by_cloud = dimming_by_cloud(photographs, night, rows);
  const std::size_t kinds = by_cloud.empty() ? weather_kinds : weather_kinds_beside_cloud;
  return {"weather", SharedBy::night, changes.columns() * kinds * weather_sectors,
          [=](const Measurement& m) { return photographs[m.photograph].errors.weather_error; },
          [=](const Measurement& m, std::size_t parameter) {
            const auto kind = parameter / weather_sectors % kinds;
            const double of_kind =
                by_cloud.empty() || kind == weather_of_blue
                    ? light_by_weather(kind, m.channel,
                                       photographs[m.photograph].scene->distances_km[m.bin])
                    : by_cloud(m.photograph * rows.bins + m.bin, m.channel);
            return limbs[m.photograph](m.bin, parameter % weather_sectors) * of_kind *
                   changes(m.photograph, parameter / weather_sectors / kinds);
          }};
}

}  // namespace coppermoon::uses
