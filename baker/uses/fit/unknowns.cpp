// SPDX-License-Identifier: MIT
#include "uses/fit/unknowns.h"

#include <cmath>

#include "atmosphere/presets.h"

namespace coppermoon::uses {
namespace {

constexpr std::array<Unknown, 3> of_factors{
    {{"stratospheric-factor", "stratospheric_factor", "stratospheric aerosol", "times the month's",
      0.1, 20, true, 0.7},
     {"cloud-chance", "cloud_chance", "chance of cloud", "times the usual", 0.05, 5, true, 0.7},
     {"ozone-factor", "ozone_factor", "ozone", "times the month's", 0.4, 1.7, false, 0.15}}};

constexpr std::array<Unknown, 3> of_amounts{
    {{"dust-extinction", "dust_extinction_per_m", "dust", "1/m", 2e-7, 3e-5, true, 0},
     {"cloud-cover", "cloud_cover", "cloud cover", "", 0, 1, false, 0},
     {"ozone-du", "ozone_du", "ozone", "DU", 100, 500, false, 0}}};

}  // namespace

double Unknown::on_axis(double value) const { return logarithmic ? std::log(value) : value; }

double Unknown::from_axis(double place) const { return logarithmic ? std::exp(place) : place; }

double Unknown::chi_squared_of_prior(double place) const {
  if (deviation == 0) return 0;
  const double off = (place - on_axis(1)) / deviation;
  return off * off;
}

const std::array<Unknown, 3>& unknowns_of(Unknowns unknowns) {
  return unknowns == Unknowns::factors ? of_factors : of_amounts;
}

AirRange whole_range(Unknowns unknowns) {
  AirRange range;
  for (std::size_t a = 0; a < range.size(); ++a)
    range[a] = {unknowns_of(unknowns)[a].least, unknowns_of(unknowns)[a].most};
  return range;
}

Unknowns usual_unknowns(const Air& air) {
  const bool deck = air.column.cloud_cover || air.column.cloud_top_km,
             of_a_month = !atmosphere::preset(air.atmosphere, {}).belts.empty();
  return of_a_month && !deck ? Unknowns::factors : Unknowns::amounts;
}

Air with_unit_factors(Air air) {
  air.column.cloud_chance = 1;
  air.column.stratospheric_factor = air.column.ozone_factor = 1;
  return air;
}

Air with_unknowns(Air air, Unknowns unknowns, const AirNumbers& numbers) {
  const auto& [aerosol, cloud, ozone] = numbers;
  auto& column = air.column;
  if (unknowns == Unknowns::factors) {
    column.stratospheric_factor = aerosol;
    column.cloud_chance = cloud;
    column.ozone_factor = ozone;
  } else {
    column.dust_extinction_per_m = aerosol;
    column.cloud_cover = cloud;
    column.ozone_du = ozone;
  }
  return air;
}

}  // namespace coppermoon::uses
