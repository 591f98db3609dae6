// SPDX-License-Identifier: MIT
#include "atmosphere/ozone.h"

#include <cmath>
#include <vector>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/quadrature.h"
#include "algebra/table.h"
#include "atmosphere/refractivity.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {
namespace {

double column(const algebra::MonotoneCubic& log_density, const std::vector<double>& altitude_m) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < altitude_m.size(); ++i) {
    const double middle = (altitude_m[i] + altitude_m[i + 1]) / 2, half = middle - altitude_m[i];
    for (const auto& node : algebra::gauss_legendre(20))
      sum += half * node.weight * std::exp(log_density(middle + half * node.x));
  }
  return sum;
}

struct OzoneProfile {
  algebra::MonotoneCubic log_share_per_m;
  double top_m;
};

OzoneProfile standard_ozone() {
  const auto table = algebra::parse_table(tables::ozone_profile(), "ozone_profile.csv");
  auto altitude_m = table["altitude_km"], log_density = table["number_density_per_m3"];
  for (double& h : altitude_m) h *= 1e3;
  for (double& n : log_density) n = std::log(n);
  const double log_column = std::log(column({altitude_m, log_density}, altitude_m));
  for (double& n : log_density) n -= log_column;
  return {{altitude_m, log_density}, altitude_m.back()};
}

}  // namespace

double ozone_cross_section_m2(algebra::Wavelength wavelength) {
  static const auto table =
      algebra::parse_table(tables::ozone_cross_section(), "ozone_cross_section.csv");
  const double nm = algebra::in_nanometres(wavelength);
  algebra::require_within("wavelength [nm]", nm, shortest_nm, longest_nm);
  return algebra::interpolated(table["wavelength_nm"], table["cross_section_m2"], nm);
}

double ozone_profile_per_m(double altitude_m) {
  static const auto ozone = standard_ozone();
  return altitude_m > ozone.top_m ? 0 : std::exp(ozone.log_share_per_m(altitude_m));
}

double ozone_filter_yapo_cutler(algebra::Wavelength wavelength, double dobson_units) {
  algebra::require_within("ozone [DU]", dobson_units, 0, 1000);
  return std::exp(-grazing_ozone_air_mass * ozone_cross_section_m2(wavelength) * dobson_units *
                  dobson_unit_per_m2);
}

}  // namespace coppermoon::atmosphere
