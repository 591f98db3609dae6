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

double integral_nm(std::span<const double> x, std::span<const double> y, double from, double to) {
  const double left = std::max(from, x.front()), right = std::min(to, x.back());
  return right > left ? (right - left) * algebra::mean_between(x, y, left, right) : 0;
}

}  // namespace

algebra::Grid<double> xyz_weights(std::span<const double> edges_nm) {
  require_increasing(edges_nm);
  static const auto observer =
      algebra::parse_table(tables::cie_1931_observer(), "cie_1931_observer.csv");
  constexpr std::array<std::string_view, 3> functions{"x_bar", "y_bar", "z_bar"};
  algebra::Grid<double> weights(3, edges_nm.size() - 1);
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t band = 0; band < weights.columns(); ++band)
      weights(row, band) = luminous_efficacy_lm_per_W *
                           integral_nm(observer["wavelength_nm"], observer[functions[row]],
                                       edges_nm[band], edges_nm[band + 1]);
  return weights;
}

}  // namespace coppermoon::colour
