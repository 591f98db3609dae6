// SPDX-License-Identifier: MIT
#include "atmosphere/twilight_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

constexpr std::size_t channels = 3;
constexpr std::array azimuths_deg{0., 15., 30., 45., 60., 90., 120., 150., 180.};
enum Air : std::size_t { standard, clear, hazy, more_ozone, high, airs };

/// Logarithms of light from the table, as [air][Sun][altitude][azimuth][channel]. The Sun's altitude decreases.
struct LightTable {
  std::vector<double> suns_deg, altitudes_deg, log_light;

  double at(std::size_t air, std::size_t sun, std::size_t within) const {
    return log_light[(air * suns_deg.size() + sun) * of_a_sun() + within];
  }
  std::size_t of_a_sun() const { return altitudes_deg.size() * azimuths_deg.size() * channels; }
};

LightTable read_table() {
  const auto table = algebra::parse_table(tables::twilight_sky(), "twilight_sky.csv");
  const auto &suns = table["sun_deg"], &altitudes = table["altitude_deg"];
  LightTable all;
  for (std::size_t row = 0; suns[row] == suns[0]; ++row)
    all.altitudes_deg.push_back(altitudes[row]);
  for (std::size_t row = 0; row < suns.size() / airs; row += all.altitudes_deg.size())
    all.suns_deg.push_back(suns[row]);
  std::array<const std::vector<double>*, azimuths_deg.size() * channels> columns{};
  for (std::size_t c = 0; c < columns.size(); ++c)
    columns[c] = &table[fmt::format("{}_{:g}", "rgb"[c % channels], azimuths_deg[c / channels])];
  for (std::size_t row = 0; row < suns.size(); ++row)
    for (const auto* column : columns)
      all.log_light.push_back((*column)[row] * std::numbers::ln10 / 1000);
  return all;
}

/// Weights of the table's atmospheres in an interpolation to the observer's air. The weights add up to 1.
std::array<double, airs> shares_of(const ObserverAir& air) {
  constexpr double standard_aerosol = 0.1, clear_aerosol = 0.03, hazy_aerosol = 0.3,
                   least_aerosol = 0.01, most_aerosol = 1, standard_du = 300, more_du = 450,
                   high_m = 3000;
  require_valid(air);
  std::array<double, airs> shares{};
  const double aerosol = std::clamp(air.aerosol_optical_depth, least_aerosol, most_aerosol);
  const double beyond = std::log(aerosol / standard_aerosol);
  shares[beyond < 0 ? clear : hazy] =
      beyond / std::log((beyond < 0 ? clear_aerosol : hazy_aerosol) / standard_aerosol);
  shares[more_ozone] = (air.ozone_du - standard_du) / (more_du - standard_du);
  shares[high] =
      (1 - pressure_ratio_us_1976(air.elevation_m)) / (1 - pressure_ratio_us_1976(high_m));
  double others = 0;
  for (const Air other : {clear, hazy, more_ozone, high}) others += shares[other];
  shares[standard] = 1 - others;
  return shares;
}

/// Logarithms of the sky's light for a solar altitude and the observer's air: [altitude in the sky][azimuth][channel].
/// Below the table's lowest solar altitude, they continue to fall at the mean rate between its two lowest altitudes.
std::vector<double> light_under(const LightTable& table, double sun_deg,
                                const std::array<double, airs>& shares) {
  const auto& suns_deg = table.suns_deg;
  std::vector<double> suns, lights(suns_deg.size()), light(table.of_a_sun());
  for (const double sun : suns_deg) suns.push_back(-sun);
  const auto last = suns.size() - 1;
  double fall = 0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    for (std::size_t s = 0; s < suns.size(); ++s) {
      lights[s] = 0;
      for (std::size_t air = 0; air < airs; ++air)
        if (shares[air] != 0) lights[s] += shares[air] * table.at(air, s, i);
    }
    light[i] = algebra::MonotoneCubic(suns, lights)(std::min(-sun_deg, suns[last]));
    fall += (lights[last - 1] - lights[last]) / (suns[last] - suns[last - 1]);
  }
  const double below_deg = std::max(suns_deg[last] - sun_deg, 0.);
  for (double& each : light) each -= below_deg * fall / static_cast<double>(light.size());
  return light;
}

constexpr std::size_t rows = 361, columns = 61;
constexpr double row_deg = 90. / (rows - 1), column_deg = 180. / (columns - 1);

/// Light at evenly spaced azimuths, interpolated from the table's azimuths, with symmetry about 0 and 180 degrees.
std::array<double, columns> around(const std::array<double, azimuths_deg.size()>& values) {
  std::vector<double> x, y;
  const auto add = [&](double azimuth, double value) {
    x.push_back(azimuth);
    y.push_back(value);
  };
  add(-azimuths_deg[1], values[1]);
  for (std::size_t b = 0; b < values.size(); ++b) add(azimuths_deg[b], values[b]);
  add(360 - azimuths_deg[values.size() - 2], values[values.size() - 2]);
  const algebra::MonotoneCubic curve(x, y);
  std::array<double, columns> light{};
  for (std::size_t c = 0; c < columns; ++c) light[c] = curve(double(c) * column_deg);
  return light;
}

/// Makes light rise steadily to its maximum along a vertical circle and fall steadily after it. This fills dips of less
/// than 1 %, which come from interpolation between altitudes of the Sun.
void fill_dips(std::vector<double>& up) {
  const auto greatest = std::ranges::max_element(up);
  for (auto i = up.begin(); i != greatest; ++i) *(i + 1) = std::max(*i, *(i + 1));
  for (auto i = up.end() - 1; i > greatest; --i) *(i - 1) = std::max(*i, *(i - 1));
}

/// Coordinate along a vertical circle in which the logarithm of light has about the same curvature everywhere.
double height_of(double altitude_deg) { return std::log(altitude_deg + 0.8); }

/// Smooths light over about a degree, to remove the kinks that piecewise cubic interpolation leaves at its nodes.
void round_kinks(std::array<double, rows>& light) {
  constexpr int passes = 10;
  for (int pass = 0; pass < passes; ++pass) {
    double before = light[0];
    for (std::size_t r = 1; r + 1 < rows; ++r) {
      const double here = light[r];
      light[r] = (before + 2 * here + light[r + 1]) / 4;
      before = here;
    }
  }
}

}  // namespace

TwilightSky::TwilightSky(algebra::Angle sun_altitude, const ObserverAir& air)
    : light_(rows * columns) {
  static const auto table = read_table();
  const double sun_deg = algebra::in_degrees(sun_altitude);
  algebra::require_within("altitude of the Sun [degrees]", sun_deg, -90, 5);
  const auto nodes = light_under(table, sun_deg, shares_of(air));
  const auto& altitudes = table.altitudes_deg;
  std::vector<double> heights;
  for (const double altitude : altitudes) heights.push_back(height_of(altitude));
  std::array<double, rows> row_heights{};
  for (std::size_t r = 0; r < rows; ++r) row_heights[r] = height_of(double(r) * row_deg);
  for (std::size_t k = 0; k < channels; ++k) {
    std::vector<std::array<double, columns>> levels;
    for (std::size_t a = 0; a < altitudes.size(); ++a) {
      std::array<double, azimuths_deg.size()> values{};
      for (std::size_t b = 0; b < values.size(); ++b)
        values[b] = nodes[(a * azimuths_deg.size() + b) * channels + k];
      levels.push_back(around(values));
    }
    std::vector<double> up(altitudes.size());
    for (std::size_t c = 0; c < columns; ++c) {
      for (std::size_t a = 0; a < up.size(); ++a) up[a] = levels[a][c];
      fill_dips(up);
      const algebra::MonotoneCubic vertical(heights, up);
      std::array<double, rows> light{};
      for (std::size_t r = 0; r < rows; ++r) light[r] = vertical(row_heights[r]);
      round_kinks(light);
      for (std::size_t r = 0; r < rows; ++r)
        light_[r * columns + c][k] = static_cast<float>(std::exp(light[r]));
    }
  }
}

std::array<double, 3> TwilightSky::towards(algebra::Angle altitude, algebra::Angle aside) const {
  const double up = std::clamp(algebra::in_degrees(altitude), 0., 90.) / row_deg,
               away = std::abs(std::remainder(algebra::in_degrees(aside), 360)) / column_deg;
  const auto r = std::min(static_cast<std::size_t>(up), rows - 2),
             c = std::min(static_cast<std::size_t>(away), columns - 2);
  const double above = up - double(r), further = away - double(c);
  const auto *lower = &light_[r * columns + c], *upper = lower + columns;
  std::array<double, 3> light{};
  for (std::size_t k = 0; k < channels; ++k)
    light[k] = std::lerp(std::lerp(lower[0][k], lower[1][k], further),
                         std::lerp(upper[0][k], upper[1][k], further), above);
  return light;
}

}  // namespace coppermoon::atmosphere
