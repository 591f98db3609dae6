// SPDX-License-Identifier: MIT
#include "algebra/quadrature.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "algebra/error.h"

namespace coppermoon::algebra {
namespace {

constexpr int most_nodes = 64;

std::vector<QuadratureNode> computed(int count) {
  std::vector<QuadratureNode> nodes(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5)), slope = 1;
    for (int iteration = 0; iteration < 100; ++iteration) {
      double p = 1, before = 0;
      for (int k = 1; k <= count; ++k) {
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
      }
      slope = count * (x * p - before) / (x * x - 1);
      const double step = p / slope;
      x -= step;
      if (std::abs(step) < 1e-15) break;
    }
    nodes[static_cast<std::size_t>(i)] = {x, 2 / ((1 - x * x) * slope * slope)};
  }
  return nodes;
}

}  // namespace

std::span<const QuadratureNode> gauss_legendre(int count) {
  require_within("quadrature nodes", count, 1, most_nodes);
  static const auto all = [] {
    std::array<std::vector<QuadratureNode>, most_nodes + 1> tables;
    for (int n = 1; n <= most_nodes; ++n) tables[static_cast<std::size_t>(n)] = computed(n);
    return tables;
  }();
  return all[static_cast<std::size_t>(count)];
}

}  // namespace coppermoon::algebra
