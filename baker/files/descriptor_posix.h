// SPDX-License-Identifier: MIT
#pragma once

#include "files/handle.h"

namespace coppermoon::files {

/// File descriptor that a handle holds; -1 if nothing is open.
inline int descriptor_of(const Handle& handle) { return static_cast<int>(handle.number); }

}  // namespace coppermoon::files
