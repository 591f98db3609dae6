// SPDX-License-Identifier: MIT
#include "colour/cie_observer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/error.h"
#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "colour/tables.h"

namespace coppermoon::colour {
namespace {

void require_increasing(std::span<const double> edges_nm) {
  if (edges_nm.size() < 2)
    throw algebra::Error(fmt::format("band edges: {} given, allowed 2 or more", edges_nm.size()));
  for (std::size_t i = 0; i < edges_nm.size(); ++i)
    if (!std::isfinite(edges_nm[i]) || (i > 0 && edges_nm[i] <= edges_nm[i - 1]))
      throw algebra::Error(fmt::format(
          "band edge {} [nm] = {:g}, allowed: above the edge before it", i, edges_nm[i]));
}

}  // namespace

algebra::Grid<double> band_integrals(const algebra::Table& table,
                                     std::span<const std::string> columns,
                                     std::span<const double> edges_nm) {
  require_increasing(edges_nm);
  const auto& at_nm = table["wavelength_nm"];
  algebra::Grid<double> integrals(columns.size(), edges_nm.size() - 1);
  for (std::size_t row = 0; row < integrals.rows(); ++row) {
    const auto& curve = table[columns[row]];
    for (std::size_t band = 0; band < integrals.columns(); ++band) {
      const double left = std::max(edges_nm[band], at_nm.front()),
                   right = std::min(edges_nm[band + 1], at_nm.back());
      if (right > left)
        integrals(row, band) = (right - left) * algebra::mean_between(at_nm, curve, left, right);
    }
  }
  return integrals;
}

algebra::Grid<double> xyz_weights(std::span<const double> edges_nm) {
  static const auto observer =
      algebra::parse_table(tables::cie_1931_observer(), "cie_1931_observer.csv");
  static const std::array<std::string, 3> functions{"x_bar", "y_bar", "z_bar"};
  auto weights = band_integrals(observer, functions, edges_nm);
  for (double& weight : weights.values()) weight = luminous_efficacy_lm_per_W * weight;
  return weights;
}

}  // namespace coppermoon::colour
