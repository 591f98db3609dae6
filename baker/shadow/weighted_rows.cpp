// SPDX-License-Identifier: MIT
#include "shadow/weighted_rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/weighted_rows.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void add_rows(const double* rows, int first, std::span<const NodeTerm> terms, double* sums) {
  const hn::CappedTag<double, lanes> d;
  const std::size_t width = hn::Lanes(d);
  for (std::size_t lane = 0; lane < lanes; lane += width) {
    auto a = hn::Load(d, sums + lane), b = hn::Zero(d), c = hn::Zero(d);
    for (const auto& term : terms) {
      const double* row =
          rows + static_cast<std::size_t>(term.node - first) * moments * lanes + lane;
      a = hn::MulAdd(hn::Set(d, term.factors[0]), hn::LoadU(d, row), a);
      b = hn::MulAdd(hn::Set(d, term.factors[1]), hn::LoadU(d, row + lanes), b);
      c = hn::MulAdd(hn::Set(d, term.factors[2]), hn::LoadU(d, row + 2 * lanes), c);
    }
    hn::Store(hn::Add(a, hn::Add(b, c)), d, sums + lane);
  }
}

}  // namespace coppermoon::shadow::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::shadow {

HWY_EXPORT(add_rows);

void add_weighted_rows(const double* rows, int first, std::span<const NodeTerm> terms,
                       double* sums) {
  HWY_DYNAMIC_DISPATCH(add_rows)(rows, first, terms, sums);
}

}  // namespace coppermoon::shadow
#endif
