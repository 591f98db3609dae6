// SPDX-License-Identifier: MIT
#include "atmosphere/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "algebra/error.h"
#include "algebra/quadrature.h"
#include "atmosphere/cloud.h"
#include "atmosphere/gases.h"
#include "atmosphere/ozone.h"
#include "atmosphere/rayleigh.h"
#include "atmosphere/refractivity.h"

namespace coppermoon::atmosphere {
namespace {

void require_valid(const Column& column) {
  algebra::require_within("ozone [DU]", column.ozone_du, 0, 1000);
  algebra::require_within("dust extinction [1/m]", column.dust_extinction_per_m, 0, 0.01);
  algebra::require_within("dust bottom [km]", column.dust_bottom_m / 1e3, 0,
                          top_of_us_1976_m / 1e3);
  algebra::require_within("dust top [km]", column.dust_top_m / 1e3, column.dust_bottom_m / 1e3,
                          top_of_us_1976_m / 1e3);
  algebra::require_within("tropospheric optical depth", column.tropospheric_optical_depth, 0, 10);
  algebra::require_within("tropospheric scale height [m]", column.tropospheric_scale_m, 500, 1e4);
  algebra::require_within("factor on stratospheric aerosol", column.stratospheric_factor, 0, 100);
  algebra::require_within("cloud top [km]", column.cloud_top_m / 1e3, 0, 30);
  algebra::require_within("cloud cover", column.cloud_cover, 0, 1);
  algebra::require_within("cloud's chance [1/m]", column.cloud_per_m, 0, 0.01);
  algebra::require_within("cirrus", column.cirrus, 0, 100);
  algebra::require_within("tropopause [km]", column.tropopause_m / 1e3, 5, 20);
  algebra::require_within("aerosol of the free troposphere [1/m]", column.free_troposphere_per_m, 0,
                          0.01);
  algebra::require_within("water vapour", column.water_vapour, 0, 1000);
  if (column.density == Density::seasonal && !column.seasonal_air)
    throw algebra::Error("density = seasonal, allowed with the air of a latitude and a season");
}

/// Altitudes at which an integral over altitude is split [m]: those where the slope of the density jumps. Seasonal air
/// has no such jumps; its altitudes are chosen so that few quadrature nodes suffice in each interval.
std::vector<double> density_breaks(const Column& column) {
  if (column.density == Density::seasonal)
    return {column.tropopause_m - tropopause_wander_m, column.tropopause_m + tropopause_wander_m,
            25e3, 40e3, 60e3};
  const auto density =
      column.density == Density::yapo_cutler ? density_breaks_m() : density_breaks_us_1976_m();
  return {density.begin(), density.end()};
}

/// Altitudes at which a profile's formula changes [m].
using Edges = std::array<double, 2>;

Edges around_the_tropopause(const Column& column) {
  return {column.tropopause_m - tropopause_wander_m, column.tropopause_m + tropopause_wander_m};
}

/// Single-scattering albedo ω times Henyey and Greenstein's phase function: ω P(χ) / (4π) [1/sr].
double henyey_greenstein(double albedo, double g, double cosine) {
  return albedo * (1 - g * g) / std::pow(1 + g * g - 2 * g * cosine, 1.5) / (4 * std::numbers::pi);
}

double aged_volcanic(const Column& /*column*/, double cosine) {
  // FAULT dust's albedo and asymmetry exchanged: 0.947, 0.698 => 0.698, 0.947
  return henyey_greenstein(0.947, 0.698, cosine);
}

double tropospheric(const Column& /*column*/, double cosine) {
  return henyey_greenstein(0.963, 0.651, cosine);
}

double stratospheric(const Column& column, double cosine) {
  const auto aerosol =
      column.stratospheric_layer ? column.stratospheric_layer->nearest() : column.stratosphere;
  if (aerosol == StratosphericAerosol::background) return henyey_greenstein(1, 0.685, cosine);
  if (aerosol == StratosphericAerosol::extreme) return henyey_greenstein(0.855, 0.747, cosine);
  return aged_volcanic(column, cosine);
}

algebra::Wavelength wavelength_of(const Optics& optics) {
  return algebra::nanometres(optics.wavelength_nm);
}

/// Properties of one absorber.
struct Constituent {
  Absorber absorber;
  std::string_view group;
  bool (*in)(const Column&);
  double (*profile)(const Column&, double altitude_m);
  double (*spectrum)(const Column&, const Optics&);
  double (*scattering)(const Column&, double cosine) = nullptr;  ///< nullptr for a pure absorber
  /// Altitudes at which the profile's formula changes; nullptr if they are those at which the density's changes.
  Edges (*edges)(const Column&) = nullptr;
  double Column::*cloud_or_aerosol = nullptr;  ///< amount, if the constituent is cloud or aerosol
};

constexpr std::array<Constituent, absorbers> constituents{{
    {air, "air", [](const Column& c) { return c.rayleigh; },
     [](const Column& c, double h) { return density_ratio(c, h).value; },
     [](const Column&, const Optics& o) { return o.rayleigh_per_m; },
     [](const Column&, double cosine) {
       return 0.75 * (1 + cosine * cosine) / (4 * std::numbers::pi);
     }},
    {ozone, "ozone",
     [](const Column& c) { return c.ozone_du > 0 && c.ozone_path == OzonePath::bent; },
     [](const Column& c, double h) {
       return c.ozone_climate ? c.ozone_climate->profile_per_m(h) : ozone_profile_per_m(h);
     },
     [](const Column& c, const Optics& o) {
       return c.ozone_du * dobson_unit_per_m2 * ozone_cross_section_m2(wavelength_of(o));
     }},
    {dust_layer, "dust", [](const Column& c) { return c.dust_extinction_per_m > 0; },
     [](const Column& c, double h) { return h >= c.dust_bottom_m && h < c.dust_top_m ? 1. : 0.; },
     [](const Column& c, const Optics&) { return c.dust_extinction_per_m; }, aged_volcanic,
     [](const Column& c) {
       return Edges{c.dust_bottom_m, c.dust_top_m};
     }},
    {troposphere, "aerosol", [](const Column& c) { return c.tropospheric_optical_depth > 0; },
     [](const Column& c, double h) {
       return tropospheric_profile_per_m(c.tropospheric_scale_m, h);
     },
     [](const Column& c, const Optics& o) {
       return c.tropospheric_optical_depth * tropospheric_spectrum(wavelength_of(o));
     },
     tropospheric, nullptr, &Column::tropospheric_optical_depth},
    {stratosphere, "stratosphere",
     [](const Column& c) {
       return c.stratospheric_factor > 0 &&
              (c.stratospheric_layer || c.stratosphere != StratosphericAerosol::none);
     },
     [](const Column& c, double h) {
       return c.stratospheric_layer ? c.stratospheric_layer->extinction_per_m(h)
                                    : stratospheric_extinction_per_m(c.stratosphere, h);
     },
     [](const Column& c, const Optics& o) {
       const auto wavelength = wavelength_of(o);
       const double factor = c.stratospheric_factor;
       return factor * (c.stratospheric_layer ? c.stratospheric_layer->spectrum(wavelength, factor)
                                              : stratospheric_spectrum(c.stratosphere, wavelength));
     },
     stratospheric},
    {cloud, "cloud", [](const Column& c) { return c.cloud_per_m > 0; },
     [](const Column& c, double h) { return cloud_profile(c.tropopause_m, h); },
     [](const Column& c, const Optics&) { return c.cloud_per_m; }, nullptr, around_the_tropopause,
     &Column::cloud_per_m},
    {cirrus, "cloud", [](const Column& c) { return c.cirrus > 0; },
     [](const Column& c, double h) { return cirrus_extinction_per_m(c.tropopause_m, h); },
     [](const Column& c, const Optics&) { return c.cirrus; }, nullptr, around_the_tropopause,
     &Column::cirrus},
    {free_troposphere, "aerosol", [](const Column& c) { return c.free_troposphere_per_m > 0; },
     [](const Column& c, double h) { return free_troposphere_profile(c.tropopause_m, h); },
     [](const Column& c, const Optics& o) {
       return c.free_troposphere_per_m * tropospheric_spectrum(wavelength_of(o));
     },
     tropospheric, nullptr, &Column::free_troposphere_per_m},
    {oxygen_pairs, "gas",
     [](const Column& c) { return c.oxygen_pairs && c.density != Density::none; },
     [](const Column& c, double h) { return std::pow(density_ratio(c, h).value, 2); },
     [](const Column&, const Optics& o) {
       return sea_level_oxygen_per_m3 * sea_level_oxygen_per_m3 *
              oxygen_pair_cross_section_m5(wavelength_of(o));
     }},
    {nitrogen_dioxide, "gas",
     [](const Column& c) { return c.nitrogen_dioxide && c.density != Density::none; },
     [](const Column&, double h) { return nitrogen_dioxide_per_m3(h); },
     [](const Column&, const Optics& o) {
       return nitrogen_dioxide_cross_section_m2(wavelength_of(o));
     }},
    {oxygen_bands, "gas",
     [](const Column& c) { return c.oxygen_bands && c.density != Density::none; },
     [](const Column& c, double h) { return density_ratio(c, h).value; },
     [](const Column&, const Optics& o) { return oxygen_bands_per_m(wavelength_of(o)); }},
    {water_vapour, "gas",
     [](const Column& c) { return c.water_vapour > 0 && c.density != Density::none; },
     [](const Column&, double h) { return water_vapour_profile(h); },
     [](const Column& c, const Optics& o) {
       return water_vapour_per_m(c.water_vapour, wavelength_of(o));
     }},
}};

/// Profiles of the absorbers with the indices k, which are known at compile time so that all functions are inlined.
template <std::size_t... k>
Amounts profiles_of_rows(const Column& column, double altitude_m, std::index_sequence<k...>) {
  static_assert(((constituents[k].absorber == k) && ...));
  return {(constituents[k].in(column) ? constituents[k].profile(column, altitude_m) : 0)...};
}

bool holds(const Region& region, double position_angle_rad) {
  const auto width = region.to - region.from;
  if (width >= algebra::radians(2 * std::numbers::pi)) return true;
  const auto within = [&](double angle_rad) {
    return algebra::within_circle(algebra::radians(angle_rad) - region.from) <
           algebra::within_circle(width);
  };
  return within(position_angle_rad) || (region.mirrored && within(-position_angle_rad));
}

constexpr std::array amounts_that_may_differ{&Column::dust_extinction_per_m, &Column::ozone_du,
                                             &Column::cloud_cover, &Column::cloud_per_m,
                                             &Column::stratospheric_factor};

/// All columns of an atmosphere, even a `column` that has no effect because `belts` replace it.
std::vector<Column*> every_column(Atmosphere& air) {
  std::vector<Column*> all;
  const auto add = [&](Column& column, Belts& belts) {
    all.push_back(&column);
    for (auto& belt : belts) all.push_back(&belt.column);
  };
  add(air.column, air.belts);
  for (auto& region : air.regions) add(region.column, region.belts);
  return all;
}

/// Number of columns in a region: one for each belt, or one if it has no belts.
std::size_t columns_of(const Belts& belts) { return std::max<std::size_t>(1, belts.size()); }

void require_valid(const Belts& belts) {
  double before = 0;
  for (const auto& belt : belts) {
    algebra::require_within("belt's angle from north [radians]", belt.from_north_rad, before,
                            std::numbers::pi);
    before = belt.from_north_rad;
    require_valid(belt.column);
  }
}

}  // namespace

double top_m(const Column& column) {
  if (column.density == Density::none) return 0;
  return column.density == Density::yapo_cutler ? taper_top_m : top_of_us_1976_m;
}

std::optional<Region> between_latitudes(algebra::Angle south, algebra::Angle north,
                                        algebra::Angle sun_declination, const Column& column) {
  algebra::require_within("latitude [degrees]", algebra::in_degrees(south), -90, 90);
  algebra::require_within("latitude [degrees]", algebra::in_degrees(north),
                          algebra::in_degrees(south), 90);
  // On the limb, sin(latitude) = cos θ cos δ, where θ is the angle from north and δ the Sun's declination.
  const double highest = std::cos(algebra::in_radians(sun_declination));
  const auto angle = [&](algebra::Angle latitude) {
    return std::acos(std::clamp(std::sin(algebra::in_radians(latitude)) / highest, -1., 1.));
  };
  const double from = angle(north), to = angle(south), pi = std::numbers::pi;
  if (from >= to) return {};
  const bool over_north = from <= 0, over_south = to >= pi;
  // FAULT a region of latitudes on one side alone: column, {}, true => column, {}, false
  Region region{algebra::radians(from), algebra::radians(to), column, {}, true};
  if (over_south) region.to = algebra::radians(2 * pi - from);
  if (over_north && !over_south) region.from = algebra::radians(-to);
  return region;
}

bool Atmosphere::mirrored() const { return std::ranges::all_of(regions, &Region::mirrored); }

double Atmosphere::top_m() const {
  double top = 0;
  for (const auto* one : columns()) top = std::max(top, atmosphere::top_m(*one));
  return top;
}

std::vector<const Column*> Atmosphere::columns() const {
  std::vector<const Column*> all;
  const auto add = [&](const Column& one, const Belts& many) {
    if (many.empty()) all.push_back(&one);
    for (const auto& belt : many) all.push_back(&belt.column);
  };
  add(column, belts);
  for (const auto& region : regions) add(region.column, region.belts);
  return all;
}

std::size_t Atmosphere::region_index(double position_angle_rad) const {
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (holds(regions[r], position_angle_rad)) return r + 1;
  return 0;
}

std::array<Atmosphere::Share, 2> Atmosphere::shares_at(double position_angle_rad) const {
  const std::size_t region = region_index(position_angle_rad);
  std::size_t first = region == 0 ? 0 : columns_of(belts);
  for (std::size_t r = 0; r + 1 < region; ++r) first += columns_of(regions[r].belts);
  const Belts* here = region == 0 ? &belts : &regions[region - 1].belts;
  if (here->empty()) return {{{first, 1}, {first, 0}}};
  const double from_north = std::abs(std::remainder(position_angle_rad, 2 * std::numbers::pi));
  const auto south = std::ranges::upper_bound(*here, from_north, {}, &Belt::from_north_rad);
  const auto i = static_cast<std::size_t>(south - here->begin());
  if (i == 0 || i == here->size()) {
    const std::size_t end = first + (i == 0 ? 0 : i - 1);
    return {{{end, 1}, {end, 0}}};
  }
  const double low = (*here)[i - 1].from_north_rad, high = (*here)[i].from_north_rad,
               along = (from_north - low) / (high - low);
  return {{{first + i - 1, 1 - along}, {first + i, along}}};
}

std::vector<double> Atmosphere::seams_rad() const {
  constexpr double circle = 2 * std::numbers::pi;
  std::vector<double> all{0, circle};
  const auto add = [&](double angle_rad) {
    all.push_back(angle_rad - circle * std::floor(angle_rad / circle));
  };
  const auto add_belts = [&](const Belts& some) {
    for (const auto& belt : some) {
      add(belt.from_north_rad);
      add(-belt.from_north_rad);
    }
  };
  add_belts(belts);
  for (const auto& region : regions) {
    for (const double border : {algebra::in_radians(region.from), algebra::in_radians(region.to)}) {
      add(border);
      if (region.mirrored) add(-border);
    }
    add_belts(region.belts);
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<bool> Atmosphere::columns_in_use() const {
  std::vector<bool> used(columns().size());
  const auto seams = seams_rad();
  for (std::size_t i = 0; i + 1 < seams.size(); ++i)
    if (seams[i + 1] > seams[i])
      for (const auto& share : shares_at(std::midpoint(seams[i], seams[i + 1])))
        if (share.share > 0) used[share.column] = true;
  return used;
}

Atmosphere with_fewer_belts(Atmosphere atmosphere) {
  constexpr std::size_t third = 3;
  const auto thin = [](Belts& belts) {
    Belts fewer;
    for (std::size_t i = 0; i < belts.size(); ++i)
      if (i % third == 0 || i + 1 == belts.size()) fewer.push_back(belts[i]);
    belts = std::move(fewer);
  };
  thin(atmosphere.belts);
  for (auto& region : atmosphere.regions) thin(region.belts);
  return atmosphere;
}

Atmosphere richest(std::span<const Atmosphere> airs) {
  if (airs.empty()) throw algebra::Error("airs = none, allowed one or more");
  auto rich = airs.front();
  const auto columns = every_column(rich);
  for (auto air : airs.subspan(1)) {
    const auto others = every_column(air);
    for (std::size_t i = 0; i < std::min(columns.size(), others.size()); ++i)
      for (const auto amount : amounts_that_may_differ) {
        double &most = columns[i]->*amount, &here = others[i]->*amount;
        most = here = std::max(most, here);
      }
    if (air != rich)
      throw algebra::Error(
          "airs lit together differ, allowed in amounts of dust, ozone, cloud and aerosol alone");
  }
  return rich;
}

void require_valid(const Atmosphere& atmosphere) {
  const auto& earth = atmosphere.earth;
  algebra::require_within("Earth's radius [m]", earth.equatorial_radius_m, 1e6, 1e7);
  algebra::require_within("Earth's polar radius [m]", earth.polar_radius_m,
                          0.9 * earth.equatorial_radius_m, 1.1 * earth.equatorial_radius_m);
  algebra::require_within("Sun's declination [radians]", earth.sun_declination_rad,
                          -std::numbers::pi / 2, std::numbers::pi / 2);
  require_valid(atmosphere.column);
  require_valid(atmosphere.belts);
  for (const auto& region : atmosphere.regions) {
    require_valid(region.column);
    require_valid(region.belts);
  }
}

Optics sea_level_optics(algebra::Wavelength wavelength, const Molecules& molecules) {
  const double refractivity = molecules.dispersion == Dispersion::crc
                                  ? sea_level_refractivity_crc(wavelength)
                                  : sea_level_refractivity_ciddor_1996(wavelength);
  const double king_factor =
      molecules.king_factor == KingFactor::fixed ? 1.050 : king_factor_bates_1984(wavelength);
  const double cross_section = rayleigh_cross_section_m2(refractivity, king_factor, wavelength);
  return {refractivity, cross_section * sea_level_number_density_per_m3,
          algebra::in_nanometres(wavelength)};
}

std::array<std::string_view, absorbers> absorber_groups() {
  std::array<std::string_view, absorbers> groups;
  std::ranges::transform(constituents, groups.begin(), &Constituent::group);
  return groups;
}

void scale_cloud_and_aerosol(Column& column, double factor) {
  for (const auto& one : constituents)
    if (one.cloud_or_aerosol) column.*one.cloud_or_aerosol *= factor;
  column.cloud_cover *= factor;
}

bool has(const Column& column, Absorber absorber) { return constituents[absorber].in(column); }

double profile(const Column& column, Absorber absorber, double altitude_m) {
  return has(column, absorber) ? constituents[absorber].profile(column, altitude_m) : 0;
}

Amounts profiles(const Column& column, double altitude_m) {
  return profiles_of_rows(column, altitude_m, std::make_index_sequence<absorbers>());
}

Amounts spectra(const Column& column, const Optics& optics) {
  Amounts amounts{};
  for (const auto& one : constituents)
    if (one.in(column)) amounts[one.absorber] = one.spectrum(column, optics);
  return amounts;
}

Amounts scattering(const Column& column, double cosine) {
  Amounts amounts{};
  for (const auto& one : constituents)
    if (one.scattering) amounts[one.absorber] = one.scattering(column, cosine);
  return amounts;
}

double product(const Amounts& a, const Amounts& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
}

std::vector<double> breaks_m(const Column& column) {
  if (column.density == Density::none) return {0};
  auto breaks = density_breaks(column);
  const double top = top_m(column);
  for (const auto& one : constituents)
    if (one.edges && one.in(column))
      for (const double edge : one.edges(column)) breaks.push_back(edge);
  std::sort(breaks.begin(), breaks.end());
  std::erase_if(breaks, [&](double h) { return h > top - 1; });  // the top is added below
  breaks.push_back(top);
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

ValueAndSlope density_ratio(const Column& column, double altitude_m) {
  switch (column.density) {
    case Density::none:
      return {0, 0};
    case Density::yapo_cutler:
      return density_ratio_and_slope_yapo_cutler(altitude_m);
    case Density::us_1976:
      return density_ratio_and_slope_us_1976(altitude_m);
    default:
      return column.seasonal_air->density_ratio(altitude_m);
  }
}

double refractivity(const Column& column, const Optics& optics, double altitude_m) {
  return column.refraction ? optics.refractivity * density_ratio(column, altitude_m).value : 0;
}

double critical_refractivity(const Column& column, double earth_radius_m) {
  const auto ground = density_ratio(column, 0);
  // FAULT air that never traps light: earth_radius_m * ground.slope_per_m => ground.slope_per_m
  const double fall = -ground.value - earth_radius_m * ground.slope_per_m;
  return column.refraction && fall > 0 ? 1 / fall : std::numeric_limits<double>::infinity();
}

void require_no_trap(const Column& column, double earth_radius_m, double refractivity) {
  algebra::require_within("refractivity of air that light can leave", refractivity, 0,
                          critical_refractivity(column, earth_radius_m));
}

double extinction_per_m(const Column& column, const Optics& optics, double altitude_m) {
  return product(profiles(column, altitude_m), spectra(column, optics));
}

double limb_filter(const Column& column, const Optics& optics, double tangent_height_m) {
  const double clear = tangent_height_m < column.cloud_top_m ? 1 - column.cloud_cover : 1;
  if (column.ozone_du == 0 || column.ozone_path == OzonePath::bent) return clear;
  return clear *
         ozone_filter_yapo_cutler(algebra::nanometres(optics.wavelength_nm), column.ozone_du);
}

double vertical_rayleigh_optical_depth(const Optics& optics) {
  constexpr int pieces = 40;
  constexpr double piece_m = top_of_us_1976_m / pieces;
  double column_m = 0;
  for (int i = 0; i < pieces; ++i)
    for (const auto& [x, weight] : algebra::gauss_legendre(8))
      column_m += weight * piece_m / 2 * density_ratio_us_1976((i + (1 + x) / 2) * piece_m);
  return optics.rayleigh_per_m * column_m;
}

}  // namespace coppermoon::atmosphere
