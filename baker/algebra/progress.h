// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace coppermoon::algebra {

/// A callback that is told the fraction done, 0 to 1, now and then, from any thread; may be empty.
using Progress = std::function<void(double)>;

}  // namespace coppermoon::algebra
