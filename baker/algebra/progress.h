// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace coppermoon::algebra {

/// Callback that is told now and then, from any thread, which fraction of the work is done, 0 to 1. It may be empty.
using Progress = std::function<void(double)>;

}  // namespace coppermoon::algebra
