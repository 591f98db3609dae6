// SPDX-License-Identifier: MIT
#include "shadow/weighted_rows.h"

#include <algorithm>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/weighted_rows.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void add_rows(const double* rows, std::span<const NodeTerm> terms, double* sums) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t lane = 0; lane < lanes; lane += width) {
    auto a = hn::Load(d, sums + lane), b = hn::Zero(d), c = hn::Zero(d);
    for (const auto& term : terms) {
      const double* row = rows + static_cast<std::size_t>(term.node) * moments * lanes + lane;
      a = hn::MulAdd(hn::Set(d, term.factors[0]), hn::LoadU(d, row), a);
      b = hn::MulAdd(hn::Set(d, term.factors[1]), hn::LoadU(d, row + lanes), b);
      c = hn::MulAdd(hn::Set(d, term.factors[2]), hn::LoadU(d, row + 2 * lanes), c);
    }
    hn::Store(hn::Add(a, hn::Add(b, c)), d, sums + lane);
  }
}

void add_at(const double* rows, int first, int last, std::span<const int> nodes, double factor,
            double* sums) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  const auto weight = hn::Set(d, factor);
  for (const int node : nodes) {
    const double* row =
        rows + static_cast<std::size_t>(std::clamp(node, first, last) - first) * moments * lanes;
    for (std::size_t i = 0; i < moments * lanes; i += width, sums += width)
      hn::StoreU(hn::MulAdd(weight, hn::LoadU(d, row + i), hn::LoadU(d, sums)), d, sums);
  }
}

/// sums[k][m][lane], each lane its share of the nodes.
void add_lanes(std::span<const double> cosines, const algebra::Grid<double>& weights,
               std::size_t harmonics, double* sums) {
  const hn::CappedTag<double, nodes_together> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t j = 0; j < cosines.size(); j += width) {
    const auto twice = hn::Mul(hn::Set(d, 2.), hn::LoadU(d, &cosines[j]));
    auto before = hn::LoadU(d, &cosines[j]), now = hn::Set(d, 1.);  // cos(−ψ), cos 0
    for (std::size_t m = 0; m < harmonics; ++m) {
      for (std::size_t k = 0; k < weights.rows(); ++k) {
        double* sum = sums + (k * harmonics + m) * nodes_together;
        hn::StoreU(hn::MulAdd(hn::LoadU(d, &weights.row(k)[j]), now, hn::LoadU(d, sum)), d, sum);
      }
      const auto next = hn::MulSub(twice, now, before);
      before = now;
      now = next;
    }
  }
}

}  // namespace coppermoon::shadow::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::shadow {

HWY_EXPORT(add_rows);

void add_weighted_rows(const double* rows, std::span<const NodeTerm> terms, double* sums) {
  HWY_DYNAMIC_DISPATCH(add_rows)(rows, terms, sums);
}

HWY_EXPORT(add_at);

void add_rows_at(const double* rows, int first, int last, std::span<const int> nodes, double factor,
                 double* sums) {
  HWY_DYNAMIC_DISPATCH(add_at)(rows, first, last, nodes, factor, sums);
}

HWY_EXPORT(add_lanes);

void add_harmonics(std::span<const double> cosines, const algebra::Grid<double>& weights,
                   algebra::Grid<double>& harmonics) {
  std::vector<double> sums(weights.rows() * harmonics.columns() * nodes_together);
  HWY_DYNAMIC_DISPATCH(add_lanes)(cosines, weights, harmonics.columns(), sums.data());
  const double* lanes_of_sum = sums.data();
  for (double& value : harmonics.values())
    for (std::size_t i = 0; i < nodes_together; ++i) value += *lanes_of_sum++;
}

}  // namespace coppermoon::shadow
#endif
