// SPDX-License-Identifier: MIT
#include "uses/light/air.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "atmosphere/presets.h"

namespace coppermoon::uses {
namespace {

using atmosphere::Column;

/// Regions at most, five degrees of the limb each: they take two minutes of computing, twice as many six.
constexpr std::size_t most_regions = 72;

Column changed(Column column, const ColumnChange& change) {
  if (change.danjon) column = atmosphere::danjon(*change.danjon, column);
  column.ozone_du = change.ozone_du.value_or(column.ozone_du);
  column.tropospheric_optical_depth =
      change.tropospheric_optical_depth.value_or(column.tropospheric_optical_depth);
  column.stratosphere = change.stratosphere.value_or(column.stratosphere);
  column.cloud_cover = change.cloud_cover.value_or(column.cloud_cover);
  column.cloud_top_m = change.cloud_top_km.value_or(column.cloud_top_m / 1e3) * 1e3;
  column.dust_extinction_per_m =
      change.dust_extinction_per_m.value_or(column.dust_extinction_per_m);
  column.dust_bottom_m = change.dust_bottom_km.value_or(column.dust_bottom_m / 1e3) * 1e3;
  column.dust_top_m = change.dust_top_km.value_or(column.dust_top_m / 1e3) * 1e3;
  return column;
}

std::vector<atmosphere::Region> regions_from(const AirRegion& region,
                                             const atmosphere::Atmosphere& air,
                                             algebra::Angle sun_declination) {
  require_place(region);
  const auto column = changed(air.column, region.column);
  if (region.from_latitude)
    return between_latitudes(algebra::degrees(*region.from_latitude),
                             algebra::degrees(*region.to_latitude), sun_declination, column);
  for (const double angle : {*region.from_position_angle, *region.to_position_angle})
    algebra::require_within("position angle [degrees]", angle, -360, 720);
  return {{algebra::degrees(*region.from_position_angle),
           algebra::degrees(*region.to_position_angle), column}};
}

void change_molecules(const Air& asked, atmosphere::Atmosphere& air) {
  air.molecules.dispersion = asked.dispersion.value_or(air.molecules.dispersion);
  air.molecules.king_factor = asked.king_factor.value_or(air.molecules.king_factor);
  air.column.ozone_path = asked.ozone_path.value_or(air.column.ozone_path);
  if (air.column.density != atmosphere::Density::none)
    air.column.density = asked.density.value_or(air.column.density);
  air.column.refraction = asked.refraction;
  air.column.rayleigh = asked.rayleigh;
}

}  // namespace

void require_place(const AirRegion& region) {
  const int latitudes = region.from_latitude.has_value() + region.to_latitude.has_value(),
            angles = region.from_position_angle.has_value() + region.to_position_angle.has_value();
  if (std::max(latitudes, angles) == 2 && std::min(latitudes, angles) == 0) return;
  throw algebra::Error(
      "needs from-latitude and to-latitude, or from-position-angle and to-position-angle "
      "[degrees]");
}

atmosphere::Atmosphere atmosphere_of(const Air& asked, algebra::Angle sun_declination) {
  auto air = atmosphere::preset(asked.atmosphere, sun_declination);
  if (asked.earth)
    air.earth = *asked.earth == EarthFigure::sphere
                    ? atmosphere::Figure{}
                    : atmosphere::ellipsoid(algebra::in_radians(sun_declination));
  change_molecules(asked, air);
  air.column = changed(air.column, asked.column);
  if (asked.regions.size() > most_regions)
    throw algebra::Error(
        fmt::format("regions = {}, allowed up to {}: each has air of its own to compute",
                    asked.regions.size(), most_regions));
  for (const auto& one : asked.regions)
    for (const auto& region : regions_from(one, air, sun_declination))
      air.regions.push_back(region);
  require_valid(air);
  return air;
}

}  // namespace coppermoon::uses
