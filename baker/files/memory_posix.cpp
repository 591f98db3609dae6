// SPDX-License-Identifier: MIT
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <fstream>
#include <limits>
#include <string>

#include "files/memory.h"

namespace coppermoon::files {

double available_memory() {
  std::ifstream file("/proc/meminfo");
  for (std::string name; file >> name;
       file.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (double kibibytes = 0; name == "MemAvailable:" && file >> kibibytes) return 1024 * kibibytes;
  return 1e9;
}

bool addresses_are_limited() {
  rlimit addresses{};
  return ::getrlimit(RLIMIT_AS, &addresses) != 0 || addresses.rlim_cur != RLIM_INFINITY;
}

bool has_addresses(std::size_t bytes) {
  void* const place =
      ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (place == MAP_FAILED) return false;
  ::munmap(place, bytes);
  return true;
}

void keep_freed_memory() {
  constexpr int largest_kept = 1 << 30;
  ::mallopt(M_MMAP_THRESHOLD, largest_kept);
  ::mallopt(M_TRIM_THRESHOLD, largest_kept);
}

}  // namespace coppermoon::files
