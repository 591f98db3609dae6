// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace coppermoon::algebra {

/// Callback that receives, now and then, from any thread, the fraction of the work that is done, 0 to 1. May be empty.
using Progress = std::function<void(double)>;

}  // namespace coppermoon::algebra
