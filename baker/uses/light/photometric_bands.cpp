// SPDX-License-Identifier: MIT
#include "uses/light/photometric_bands.h"

#include "algebra/interpolation.h"
#include "algebra/table.h"
#include "light/tables.h"

namespace coppermoon::uses {

std::vector<PhotometricBand> photometric_bands() {
  constexpr double v = -26.76, b_minus_v = 0.653, v_minus_r = 0.356;
  return {{"B", v + b_minus_v}, {"V", v}, {"R", v - v_minus_r}};
}

algebra::ByName<double> by_band(const std::vector<double>& numbers) {
  const auto bands = photometric_bands();
  algebra::ByName<double> named;
  for (std::size_t k = 0; k < numbers.size(); ++k) named.emplace_back(bands[k].name, numbers[k]);
  return named;
}

algebra::Grid<double> photometric_response(std::span<const double> edges_nm) {
  const auto table = algebra::parse_table(light::tables::johnson_cousins_bessell_1990(),
                                          "johnson_cousins_bessell_1990.csv");
  const auto bands = photometric_bands();
  algebra::Grid<double> response(bands.size(), edges_nm.size() - 1);
  for (std::size_t b = 0; b < bands.size(); ++b)
    for (std::size_t w = 0; w + 1 < edges_nm.size(); ++w)
      response(b, w) = algebra::mean_between(table["wavelength_nm"], table[bands[b].name],
                                             edges_nm[w], edges_nm[w + 1]) *
                       (edges_nm[w + 1] - edges_nm[w]);
  return response;
}

}  // namespace coppermoon::uses
