// SPDX-License-Identifier: MIT
#pragma once

#include "files/handle.h"

namespace coppermoon::files {

/// The file descriptor in a handle; -1 if nothing is open.
inline int descriptor_of(const Handle& handle) { return static_cast<int>(handle.number); }

}  // namespace coppermoon::files
