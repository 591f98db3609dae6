// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace coppermoon::shadow {

/// Length of a row that is read in whole vectors: the least multiple that holds that many values.
constexpr std::size_t padded(std::size_t count, std::size_t multiple) {
  return (count + multiple - 1) / multiple * multiple;
}

}  // namespace coppermoon::shadow
