// SPDX-License-Identifier: MIT
#include "photons/solar_disc.h"

#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "photons/tables.h"

namespace coppermoon::photons {

std::vector<double> solar_irradiance(std::span<const double> edges_nm) {
  const auto table =
      algebra::parse_table(tables::solar_irradiance_e490(), "solar_irradiance_e490.csv");
  std::vector<double> irradiance;
  for (std::size_t i = 0; i + 1 < edges_nm.size(); ++i) {
    algebra::require_within("band edge [nm]", edges_nm[i], 379, 781);
    algebra::require_within("band edge [nm]", edges_nm[i + 1], 379, 781);
    algebra::require_within("band width [nm]", edges_nm[i + 1] - edges_nm[i], 1e-6, 402);
    irradiance.push_back(algebra::mean_between(table["wavelength_nm"], table["irradiance_W_m2_nm"],
                                               edges_nm[i], edges_nm[i + 1]));
  }
  return irradiance;
}

glm::dvec2 random_place_on_disc(algebra::Random& random) {
  // FAULT photons crowd in the middle of the Sun: std::sqrt(random.uniform()) => random.uniform()
  const double radius = std::sqrt(random.uniform());
  const double angle = 2 * std::numbers::pi * random.uniform();
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace coppermoon::photons
