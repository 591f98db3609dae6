// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace coppermoon::algebra {

/// Callback for progress: gets the fraction done, 0 to 1, now and then, from any thread; may be empty.
using Progress = std::function<void(double)>;

}  // namespace coppermoon::algebra
