// SPDX-License-Identifier: MIT
#include "atmosphere/ozone.h"

#include <cmath>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "atmosphere/refractivity.h"
#include "atmosphere/tables.h"

namespace coppermoon::atmosphere {

double ozone_cross_section_m2(algebra::Wavelength wavelength) {
  static const auto table =
      algebra::parse_table(tables::ozone_cross_section(), "ozone_cross_section.csv");
  const double nm = algebra::in_nanometres(wavelength);
  algebra::require_within("wavelength [nm]", nm, shortest_nm, longest_nm);
  return algebra::interpolated(table["wavelength_nm"], table["cross_section_m2"], nm);
}

double ozone_filter_yapo_cutler(algebra::Wavelength wavelength, double dobson_units) {
  algebra::require_within("ozone [DU]", dobson_units, 0, 1000);
  return std::exp(-grazing_ozone_air_mass * ozone_cross_section_m2(wavelength) * dobson_units *
                  dobson_unit_per_m2);
}

}  // namespace coppermoon::atmosphere
