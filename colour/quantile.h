// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace coppermoon::colour {

/// Quantile: the value below which the given share (0 to 1) of all values lies. The result is one of the values,
/// without interpolation, or 0 if there are none.
template <class Number>
Number quantile(std::vector<Number> values, double share) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

}  // namespace coppermoon::colour
