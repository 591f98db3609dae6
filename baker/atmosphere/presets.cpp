// SPDX-License-Identifier: MIT
#include "atmosphere/presets.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "algebra/error.h"
#include "atmosphere/cloud.h"
#include "atmosphere/gases.h"
#include "atmosphere/tropopause.h"

namespace coppermoon::atmosphere {
namespace {

constexpr std::array<std::string_view, 7> names{"paper",    "molecular",  "clear", "undated",
                                                "standard", "calibrated", "none"};

/// Factor by which the preset "calibrated" multiplies the probability of cloud.
constexpr double calibrated_cloud = 0.60;

constexpr double us_1976_ozone_du = 345;

void make_usual(Column& column) {
  column.stratosphere = StratosphericAerosol::background;
  column.tropospheric_optical_depth = 0.07;
  column.cloud_top_m = 10e3;
  column.cloud_cover = 0.7;
}

/// Adds to a column those constituents of the preset "standard" that do not depend on latitude and month.
Column usual_by_chance(Column column) {
  column.tropospheric_optical_depth = 0.07;
  column.tropospheric_scale_m = 1.2e3;
  column.cirrus = 1;
  column.oxygen_pairs = column.oxygen_bands = column.nitrogen_dioxide = true;
  return column;
}

struct Eruption {
  StratosphericAerosol stratosphere;
  double dust_extinction_per_m, dust_top_m;
};

/// Stratospheric aerosol and dust layer for eclipses of L = 0 to 3 on Danjon's scale.
constexpr std::array<Eruption, 4> eruptions{{{StratosphericAerosol::extreme, 1e-6, 25e3},
                                             {StratosphericAerosol::high, 0, 20e3},
                                             {StratosphericAerosol::moderate, 3e-6, 20e3},
                                             {StratosphericAerosol::background, 0, 20e3}}};

}  // namespace

std::span<const std::string_view> preset_names() { return names; }

Column climatic(Column column, algebra::Angle latitude, double year) {
  column.tropopause_m = tropopause_m(latitude, year);
  column.density = Density::seasonal;
  column.seasonal_air = std::make_shared<SeasonalAir>(latitude, year);
  column.ozone_climate = std::make_shared<OzoneClimate>(latitude, year, *column.seasonal_air);
  column.ozone_du = column.ozone_climate->column_du();
  column.stratospheric_layer = std::make_shared<StratosphericLayer>(
      StratosphericLayer::of_month(year, latitude, column.tropopause_m));
  column.free_troposphere_per_m = free_troposphere_per_m(latitude);
  column.water_vapour = seasonal_water(latitude, year);
  column.cloud_per_m = cloud_chance_per_m(latitude);
  return column;
}

Belts belts_of(const Column& column) {
  constexpr int intervals = 12;
  Belts belts;
  for (int i = 0; i <= intervals; ++i) belts.push_back({std::numbers::pi * i / intervals, column});
  return belts;
}

algebra::Angle latitude_on_limb(double from_north_rad, algebra::Angle sun_declination) {
  return algebra::radians(
      std::asin(std::cos(from_north_rad) * std::cos(algebra::in_radians(sun_declination))));
}

Atmosphere preset(std::string_view name, algebra::Angle sun_declination, double year) {
  if (std::ranges::find(names, name) == names.end())
    throw algebra::Error(fmt::format("atmosphere = {}, allowed {}", name, fmt::join(names, ", ")));
  Atmosphere air;
  Column& column = air.column;
  column.ozone_du = us_1976_ozone_du;
  if (name == "paper") return air;
  air.earth = ellipsoid(algebra::in_radians(sun_declination));
  air.molecules = {Dispersion::ciddor_1996, KingFactor::bates_1984};
  column.density = name == "none" ? Density::none : Density::us_1976;
  column.ozone_path = OzonePath::bent;
  if (name == "molecular" || name == "none") column.ozone_du = 0;
  if (name == "undated") make_usual(column);
  if (name != "standard" && name != "calibrated") return air;
  air.belts = belts_of(usual_by_chance(column));
  for (auto& [from_north, belt] : air.belts) {
    belt = climatic(belt, latitude_on_limb(from_north, sun_declination), year);
    if (name == "calibrated") belt.cloud_per_m *= calibrated_cloud;
  }
  return air;
}

Column danjon(int l, Column column) {
  algebra::require_within("Danjon", l, 0, 4);
  column.stratosphere = StratosphericAerosol::none;
  column.tropospheric_optical_depth = column.cloud_cover = column.dust_extinction_per_m = 0;
  if (l == 4) return column;
  make_usual(column);
  const auto& eruption = eruptions[static_cast<std::size_t>(l)];
  column.stratosphere = eruption.stratosphere;
  column.dust_extinction_per_m = eruption.dust_extinction_per_m;
  column.dust_bottom_m = 15e3;
  column.dust_top_m = eruption.dust_top_m;
  return column;
}

}  // namespace coppermoon::atmosphere
