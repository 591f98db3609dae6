// SPDX-License-Identifier: MIT
#include <windows.h>

#include <algorithm>

#include "files/memory.h"

namespace coppermoon::files {

double available_memory() {
  MEMORYSTATUSEX status{};
  status.dwLength = sizeof status;
  if (!::GlobalMemoryStatusEx(&status)) return 1e9;
  return static_cast<double>(std::min(status.ullAvailPhys, status.ullAvailPageFile));
}

bool addresses_are_limited() { return false; }

bool has_addresses(std::size_t bytes) {
  void* const place = ::VirtualAlloc(nullptr, bytes, MEM_RESERVE, PAGE_NOACCESS);
  return place != nullptr && ::VirtualFree(place, 0, MEM_RELEASE) != 0;
}

void keep_freed_memory() {}  // the heap of Windows cannot be told to keep freed memory

}  // namespace coppermoon::files
