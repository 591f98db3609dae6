// SPDX-License-Identifier: MIT
#include "colour/bracket.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "algebra/error.h"

namespace coppermoon::colour {
namespace {

void require_alike(std::span<const Bracketed> photographs) {
  if (photographs.empty()) throw algebra::Error("no photographs, allowed one or more");
  const auto rows = photographs.front().scene_linear.rows(),
             columns = photographs.front().scene_linear.columns();
  for (const auto& [scene, valid, light] : photographs) {
    if (scene.rows() != rows || scene.columns() != columns || valid.rows() != rows ||
        valid.columns() != columns)
      throw algebra::Error(
          fmt::format("a photograph of {} x {} pixels, allowed {} x {} as the first",
                      scene.columns(), scene.rows(), columns, rows));
    if (!(light > 0)) throw algebra::Error(fmt::format("light = {:g}, allowed above 0", light));
  }
}

}  // namespace

Bracketed merged(std::span<const Bracketed> photographs) {
  require_alike(photographs);
  const auto& darkest = *std::ranges::min_element(photographs, {}, &Bracketed::light);
  Bracketed result = darkest;
  result.light = 0;
  for (const auto& photograph : photographs) result.light += photograph.light;
  tbb::parallel_for(std::size_t{0}, result.valid.values().size(), [&](std::size_t i) {
    double weight = 0;
    std::array<double, 3> sum{};
    for (const auto& [scene, valid, light] : photographs) {
      if (valid.values()[i] == 0) continue;
      // FAULT a bracket's mean with other weights: weight += light; => weight += 1;
      weight += light;
      for (std::size_t k = 0; k < 3; ++k) sum[k] += light * scene.values()[i][k];
    }
    if (weight == 0) return;
    result.valid.values()[i] = 1;
    for (std::size_t k = 0; k < 3; ++k)
      result.scene_linear.values()[i][k] = static_cast<float>(sum[k] / weight);
  });
  return result;
}

}  // namespace coppermoon::colour
