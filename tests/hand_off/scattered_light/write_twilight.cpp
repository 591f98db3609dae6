// SPDX-License-Identifier: MIT
// Prints, as JSON, the light that some airs scatter onto the shadow's axis, and what of each air another engine needs.
#include <cstdio>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numbers>

#include "atmosphere/presets.h"
#include "shadow/twilight.h"

namespace {

using namespace coppermoon;

const std::vector<double> waves_nm{420, 450, 500, 550, 600, 700};
const shadow::Arrangement moon{1.496e11, {406'099e3}};

/// Extinction [1/m] by an absorber, (altitude, wavelength).
nlohmann::json extinction(const atmosphere::Column& column, atmosphere::Absorber absorber,
                          std::span<const double> altitudes_m,
                          std::span<const atmosphere::Optics> optics) {
  auto rows = nlohmann::json::array();
  for (const double altitude_m : altitudes_m) {
    std::vector<double> row;
    for (const auto& here : optics)
      row.push_back(atmosphere::profile(column, absorber, altitude_m) *
                    atmosphere::spectra(column, here)[absorber]);
    rows.push_back(row);
  }
  return rows;
}

nlohmann::json of(const atmosphere::Column& column) {
  auto air = atmosphere::preset("molecular", algebra::degrees(0));
  air.earth = {};
  air.column = column;
  std::vector<atmosphere::Optics> optics;
  for (const double nm : waves_nm)
    optics.push_back(atmosphere::sea_level_optics(algebra::nanometres(nm), air.molecules));
  std::vector<double> altitudes_m, refractive_index;
  for (double altitude_m = 0; altitude_m < 86e3; altitude_m += 500) {
    altitudes_m.push_back(altitude_m);
    refractive_index.push_back(1 + atmosphere::refractivity(column, optics[2], altitude_m));
  }
  const std::vector<double> axis{0};
  const auto light = shadow::twilight(air, moon, waves_nm, axis);
  return {{"radius_m", air.earth.equatorial_radius_m},
          {"moon_m", moon.depths_m[0]},
          {"sun_m", moon.sun_distance_m},
          {"wavelengths_nm", waves_nm},
          {"altitudes_m", altitudes_m},
          {"refractive_index", refractive_index},
          {"air_per_m", extinction(column, atmosphere::air, altitudes_m, optics)},
          {"ozone_per_m", extinction(column, atmosphere::ozone, altitudes_m, optics)},
          {"aerosol_per_m", extinction(column, atmosphere::stratosphere, altitudes_m, optics)},
          {"twilight",
           std::vector<double>(light.ratio[0].row(0).begin(), light.ratio[0].row(0).end())}};
}

}  // namespace

int main() try {
  auto column = atmosphere::preset("clear", algebra::degrees(0)).column;
  column.ozone_du = 300;
  nlohmann::json all{{"clear", of(column)}};
  using enum atmosphere::StratosphericAerosol;
  for (const auto& [name, aerosol] :
       {std::pair{"background", background}, std::pair{"moderate", moderate},
        std::pair{"high", high}, std::pair{"extreme", extreme}}) {
    column.stratosphere = aerosol;
    all[name] = of(column);
  }
  std::cout << all << '\n';
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
