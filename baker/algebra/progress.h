// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace coppermoon::algebra {

/// Callback for progress, called now and then, from any thread, with the fraction of work done, 0 to 1. May be empty.
using Progress = std::function<void(double)>;

}  // namespace coppermoon::algebra
