// SPDX-License-Identifier: MIT
#include <sys/mman.h>
#include <sys/resource.h>

#include "files/memory.h"

namespace coppermoon::files {

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

}  // namespace coppermoon::files
