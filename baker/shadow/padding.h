// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace coppermoon::shadow {

/// Smallest multiple of `multiple` that is not below `count`. Rows of this length can be read in whole vectors.
constexpr std::size_t padded(std::size_t count, std::size_t multiple) {
  return (count + multiple - 1) / multiple * multiple;
}

}  // namespace coppermoon::shadow
