// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace coppermoon::colour {

/// Quantile of some values: a share (0 to 1) of them lies below it. Takes the nearest value below, without
/// interpolation; 0 if there are no values.
template <class Number>
Number quantile(std::vector<Number> values, double share) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace coppermoon::colour
