// SPDX-License-Identifier: MIT
#include "atmosphere/presets.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "algebra/error.h"

namespace coppermoon::atmosphere {
namespace {

constexpr std::array<std::string_view, 5> names{"paper", "molecular", "clear", "standard", "none"};

constexpr double us_1976_ozone_du = 345;

void make_usual(Column& column) {
  column.stratosphere = StratosphericAerosol::background;
  column.tropospheric_optical_depth = 0.07;
  column.cloud_top_m = 10e3;
  column.cloud_cover = 0.7;
}

struct Eruption {
  StratosphericAerosol stratosphere;
  double dust_extinction_per_m, dust_top_m;
};

/// The aerosol that hangs in the stratosphere for L from 0 to 3.
constexpr std::array<Eruption, 4> eruptions{{{StratosphericAerosol::extreme, 1e-6, 25e3},
                                             {StratosphericAerosol::high, 0, 20e3},
                                             {StratosphericAerosol::moderate, 3e-6, 20e3},
                                             {StratosphericAerosol::background, 0, 20e3}}};

}  // namespace

std::span<const std::string_view> preset_names() { return names; }

Atmosphere preset(std::string_view name, algebra::Angle sun_declination) {
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
  if (name != "standard") return air;
  make_usual(column);
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
