// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

namespace coppermoon::support {

/// Whether tests try all they can (tests/thorough.sh), or as much as every change can wait for.
inline bool thorough() { return std::getenv("COPPERMOON_THOROUGH") != nullptr; }

}  // namespace coppermoon::support
