// SPDX-License-Identifier: MIT
#include "files/memory.h"

#include <fmt/format.h>

#include "algebra/error.h"

namespace coppermoon::files {

void require_memory(std::string_view what, double bytes) {
  if (const double available = available_memory(); bytes > available)
    throw algebra::Error(
        fmt::format("{}: takes {:.1f} GB of memory, allowed the {:.1f} GB that are free", what,
                    bytes / 1e9, available / 1e9));
}

}  // namespace coppermoon::files
