// SPDX-License-Identifier: MIT
#include "uses/light/air.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>

#include "algebra/error.h"
#include "almanac/instant.h"
#include "atmosphere/cloud.h"
#include "atmosphere/gases.h"
#include "atmosphere/presets.h"
#include "eclipse/contacts.h"
#include "eclipse/shadow_axis.h"
#include "uses/light/danjon_air.h"

namespace coppermoon::uses {
namespace {

using atmosphere::Column;
using atmosphere::StratosphericAerosol;

/// Largest number of regions: one for every five degrees of the limb.
constexpr std::size_t most_regions = 72;

/// Place and time of a column of air: its latitude and the year.
struct Standing {
  algebra::Angle latitude;
  double year;
};

void change_stratosphere(const Stratosphere& asked, const Standing& standing, Column& column) {
  column.stratosphere = StratosphericAerosol::none;
  column.stratospheric_layer.reset();
  if (const auto* by_name = std::get_if<StratosphericAerosol>(&asked)) {
    column.stratosphere = *by_name;
    return;
  }
  const auto* depth = std::get_if<double>(&asked);
  using Layer = atmosphere::StratosphericLayer;
  column.stratospheric_layer = std::make_shared<Layer>(
      depth ? Layer(*depth, column.tropopause_m)
            : Layer::of_month(standing.year, standing.latitude, column.tropopause_m));
}

void change_cloud(const ColumnChange& change, const Standing& standing, Column& column) {
  const bool deck = change.cloud_cover || change.cloud_top_km;
  column.cloud_cover = change.cloud_cover.value_or(column.cloud_cover);
  column.cloud_top_m = change.cloud_top_km.value_or(column.cloud_top_m / 1e3) * 1e3;
  if (deck) column.cloud_per_m = 0;
  if (change.cloud_chance) {
    algebra::require_within("cloud chance", *change.cloud_chance, 0, 100);
    column.cloud_per_m = *change.cloud_chance * atmosphere::cloud_chance_per_m(standing.latitude);
  }
  column.cirrus = change.cirrus.value_or(deck ? 0 : column.cirrus);
}

Column changed(Column column, const ColumnChange& change, const Standing& standing) {
  if (change.danjon) column = atmosphere::danjon(*change.danjon, column);
  if (change.ozone_factor) algebra::require_within("ozone factor", *change.ozone_factor, 0, 10);
  column.ozone_du = change.ozone_factor.value_or(1) * change.ozone_du.value_or(column.ozone_du);
  column.tropospheric_optical_depth =
      change.tropospheric_optical_depth.value_or(column.tropospheric_optical_depth);
  column.tropopause_m = change.tropopause_km.value_or(column.tropopause_m / 1e3) * 1e3;
  if (change.stratosphere) change_stratosphere(*change.stratosphere, standing, column);
  column.stratospheric_factor = change.stratospheric_factor.value_or(column.stratospheric_factor);
  change_cloud(change, standing, column);
  if (change.free_troposphere) {
    algebra::require_within("free troposphere", *change.free_troposphere, 0, 100);
    column.free_troposphere_per_m =
        *change.free_troposphere * atmosphere::free_troposphere_per_m(standing.latitude);
  }
  if (change.water_vapour) {
    algebra::require_within("water vapour", *change.water_vapour, 0, 100);
    column.water_vapour =
        *change.water_vapour * atmosphere::seasonal_water(standing.latitude, standing.year);
  }
  column.dust_extinction_per_m =
      change.dust_extinction_per_m.value_or(column.dust_extinction_per_m);
  column.dust_bottom_m = change.dust_bottom_km.value_or(column.dust_bottom_m / 1e3) * 1e3;
  column.dust_top_m = change.dust_top_km.value_or(column.dust_top_m / 1e3) * 1e3;
  return column;
}

/// What the air depends on at a moment: the Sun's declination, which gives the tilt of the Earth's pole, and the year.
struct AirMoment {
  algebra::Angle sun_declination;
  double year;

  Standing at(double from_north_rad) const {
    return {atmosphere::latitude_on_limb(from_north_rad, sun_declination), year};
  }
};

atmosphere::Belts belts_in(const AirRegion& region, atmosphere::Belts belts,
                           const AirMoment& moment) {
  for (auto& belt : belts)
    belt.column = changed(belt.column, region.column, moment.at(belt.from_north_rad));
  return belts;
}

/// Converts a requested region to one on the limb. Returns nothing if the limb does not reach the region's latitudes.
std::optional<atmosphere::Region> region_on_limb(const AirRegion& region,
                                                 const atmosphere::Atmosphere& air,
                                                 const AirMoment& moment) {
  require_place(region);
  const auto column = changed(air.column, region.column, {{}, moment.year});
  std::optional<atmosphere::Region> made;
  if (region.from_latitude) {
    made = between_latitudes(algebra::degrees(*region.from_latitude),
                             algebra::degrees(*region.to_latitude), moment.sun_declination, column);
  } else {
    for (const double angle : {*region.from_position_angle, *region.to_position_angle})
      algebra::require_within("position angle [degrees]", angle, -360, 720);
    made = {algebra::degrees(*region.from_position_angle),
            algebra::degrees(*region.to_position_angle), column};
  }
  if (made) made->belts = belts_in(region, air.belts, moment);
  return made;
}

void change_profiles(const Air& asked, const Standing& standing, Column& column) {
  using atmosphere::Density;
  if (column.density != Density::none) column.density = asked.density.value_or(column.density);
  const bool of_season =
      column.density == Density::seasonal || asked.ozone_profile == OzoneProfile::climatology;
  if (of_season && !column.seasonal_air)
    column.seasonal_air =
        std::make_shared<atmosphere::SeasonalAir>(standing.latitude, standing.year);
  if (asked.ozone_profile == OzoneProfile::us_1976) column.ozone_climate.reset();
  if (asked.ozone_profile == OzoneProfile::climatology) {
    column.ozone_climate = std::make_shared<atmosphere::OzoneClimate>(
        standing.latitude, standing.year, *column.seasonal_air);
    column.ozone_du = column.ozone_climate->column_du();
  }
}

void change_terms(const Air& asked, const Standing& standing, Column& column) {
  change_profiles(asked, standing, column);
  column.ozone_path = asked.ozone_path.value_or(column.ozone_path);
  column.oxygen_pairs = asked.oxygen_pairs.value_or(column.oxygen_pairs);
  column.oxygen_bands = asked.oxygen_bands.value_or(column.oxygen_bands);
  column.nitrogen_dioxide = asked.nitrogen_dioxide.value_or(column.nitrogen_dioxide);
  column.refraction = asked.refraction;
  column.rayleigh = asked.rayleigh;
  column = changed(column, asked.column, standing);
}

bool depends_on_latitude(const ColumnChange& change) {
  const auto& stratosphere = change.stratosphere;
  return change.cloud_chance || change.free_troposphere || change.water_vapour ||
         (stratosphere && std::holds_alternative<DatedAerosol>(*stratosphere));
}

/// Whether any term of the requested air varies with latitude.
bool depends_on_latitude(const Air& asked) {
  return asked.density == atmosphere::Density::seasonal ||
         asked.ozone_profile == OzoneProfile::climatology || depends_on_latitude(asked.column) ||
         std::ranges::any_of(asked.regions,
                             [](const auto& region) { return depends_on_latitude(region.column); });
}

Air without_danjon(Air asked) {
  asked.column.danjon.reset();
  for (auto& region : asked.regions) region.column.danjon.reset();
  return asked;
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

atmosphere::Atmosphere atmosphere_of(const Air& air_asked, algebra::Angle sun_declination,
                                     double year) {
  const AirMoment moment{sun_declination, year};
  auto air = atmosphere::preset(air_asked.atmosphere, sun_declination, year);
  if (air.belts.empty() && air.top_m() > 0 && depends_on_latitude(air_asked))
    air.belts = atmosphere::belts_of(air.column);
  const auto asked = air.belts.empty() ? air_asked : without_danjon(air_asked);
  if (asked.earth)
    air.earth = *asked.earth == EarthFigure::sphere
                    ? atmosphere::Figure{}
                    : atmosphere::ellipsoid(algebra::in_radians(sun_declination));
  air.molecules.dispersion = asked.dispersion.value_or(air.molecules.dispersion);
  air.molecules.king_factor = asked.king_factor.value_or(air.molecules.king_factor);
  change_terms(asked, {{}, year}, air.column);
  for (auto& belt : air.belts) change_terms(asked, moment.at(belt.from_north_rad), belt.column);
  if (asked.regions.size() > most_regions)
    throw algebra::Error(
        fmt::format("regions = {}, allowed up to {}: each has air of its own to compute",
                    asked.regions.size(), most_regions));
  for (const auto& one : asked.regions)
    if (auto region = region_on_limb(one, air, moment)) air.regions.push_back(std::move(*region));
  require_valid(air);
  return air;
}

namespace {

AirMoment moment_of(const almanac::SkyState& sky) {
  return {eclipse::shadow_axis(sky).sun_declination, almanac::year_of(sky.when)};
}

/// Danjon's scale for the eclipse of a given night. If a region is given, its air is assumed along the whole limb.
DanjonScale scale_of(const Air& asked, const std::optional<AirRegion>& region,
                     const almanac::SkyState& night) {
  const auto greatest =
      eclipse::nearest_eclipse(night.when, eclipse::ShadowConvention::danjon).greatest;
  const auto sky = almanac::sky_at(greatest);
  const auto moment = moment_of(sky);
  auto air = atmosphere_of(asked, moment.sun_declination, moment.year);
  air.regions.clear();
  if (region) air.belts = belts_in(*region, air.belts, moment);
  return {air, sky};
}

/// Clearness (change of cloud and aerosol) at which the eclipse reaches a step on Danjon's scale. If a region is given,
/// its air is assumed along the whole limb. Scales are cached, because all frames of a film need the same scale.
double clearness_found(const Air& asked, std::optional<AirRegion> region, int step,
                       const almanac::SkyState& sky) {
  struct Found {
    Air asked;
    std::optional<AirRegion> region;
    almanac::Instant when;
    DanjonScale scale;
  };
  static std::mutex lock;
  static std::vector<Found> all;
  constexpr double a_night_s = 86400;
  constexpr std::size_t most = 64;
  const auto any_step = without_danjon(asked);
  if (region) region->column.danjon.reset();
  const std::lock_guard guard(lock);
  auto found = std::ranges::find_if(all, [&](const Found& one) {
    return one.region == region && one.asked == any_step &&
           std::abs(almanac::seconds_between(one.when, sky.when)) < a_night_s;
  });
  if (found == all.end()) {
    if (all.size() == most) all.erase(all.begin());
    found = all.insert(all.end(), {any_step, region, sky.when, scale_of(asked, region, sky)});
  }
  return found->scale.clearness(step);
}

}  // namespace

bool reaches_danjon(const Air& asked, const almanac::SkyState& sky) {
  if (!asked.column.danjon) return true;
  const auto moment = moment_of(sky);
  if (atmosphere_of(asked, moment.sun_declination, moment.year).belts.empty()) return true;
  const double clearness = clearness_found(asked, {}, *asked.column.danjon, sky);
  return clearness > darkest_clearness + clearness_error &&
         clearness < brightest_clearness - clearness_error / 2;
}

atmosphere::Atmosphere atmosphere_of(const Air& asked, const almanac::SkyState& sky) {
  const auto moment = moment_of(sky);
  auto air = atmosphere_of(asked, moment.sun_declination, moment.year);
  if (air.belts.empty()) return air;
  auto next = air.regions.begin();
  for (const auto& region : asked.regions) {
    const auto step = region.column.danjon ? region.column.danjon : asked.column.danjon;
    if (!region_on_limb(region, air, moment)) continue;
    if (step)
      next->belts =
          cleared({.belts = next->belts}, clearness_found(asked, region, *step, sky)).belts;
    ++next;
  }
  if (asked.column.danjon)
    air.belts =
        cleared({.belts = air.belts}, clearness_found(asked, {}, *asked.column.danjon, sky)).belts;
  return air;
}

}  // namespace coppermoon::uses
