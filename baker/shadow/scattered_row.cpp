// SPDX-License-Identifier: MIT
#include "shadow/scattered_row.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shadow/scattered_row.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace coppermoon::shadow::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void add_row(const atmosphere::Amounts& scattered, const atmosphere::Amounts& passed,
             const algebra::Grid<double>& spectra, std::span<const double> filter,
             std::span<double> ratio) {
  constexpr double darkest = 700;  // exp(−700) = 1e-304 is nearly the smallest double
  const hn::CappedTag<double, waves_together> d;
  for (std::size_t w = 0; w < ratio.size(); w += hn::Lanes(d)) {
    auto light = hn::Zero(d), depth = hn::Zero(d);
    for (std::size_t k = 0; k < scattered.size(); ++k) {
      if (scattered[k] == 0 && passed[k] == 0) continue;
      const auto spectrum = hn::LoadU(d, &spectra.row(k)[w]);
      light = hn::MulAdd(spectrum, hn::Set(d, scattered[k]), light);
      depth = hn::MulAdd(spectrum, hn::Set(d, passed[k]), depth);
    }
    const auto dimmed = hn::Exp(d, hn::Neg(hn::Min(depth, hn::Set(d, darkest))));
    hn::StoreU(
        hn::MulAdd(hn::Mul(hn::LoadU(d, &filter[w]), light), dimmed, hn::LoadU(d, &ratio[w])), d,
        &ratio[w]);
  }
}

}  // namespace coppermoon::shadow::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coppermoon::shadow {

HWY_EXPORT(add_row);

void add_scattered(const atmosphere::Amounts& scattered, const atmosphere::Amounts& passed,
                   const algebra::Grid<double>& spectra, std::span<const double> filter,
                   std::span<double> ratio) {
  HWY_DYNAMIC_DISPATCH(add_row)(scattered, passed, spectra, filter, ratio);
}

}  // namespace coppermoon::shadow
#endif
