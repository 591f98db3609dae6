// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace coppermoon::shadow {

/// Smallest multiple of `multiple` that is at least `count`. It is the length of a row that is read in whole vectors.
constexpr std::size_t padded(std::size_t count, std::size_t multiple) {
  return (count + multiple - 1) / multiple * multiple;
}

}  // namespace coppermoon::shadow
