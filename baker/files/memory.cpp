// SPDX-License-Identifier: MIT
#include "files/memory.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <string>

#include "algebra/error.h"

namespace coppermoon::files {

double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name;
       file.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (double kibibytes = 0; name == "MemAvailable:" && file >> kibibytes) return 1024 * kibibytes;
  return 1e9;
}

void require_memory(std::string_view what, double bytes) {
  if (const double available = available_memory(); bytes > available)
    throw algebra::Error(
        fmt::format("{}: takes {:.1f} GB of memory, allowed the {:.1f} GB that are free", what,
                    bytes / 1e9, available / 1e9));
}

}  // namespace coppermoon::files
