// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "files/handle.h"

namespace coppermoon::files {

/// The Windows HANDLE that is stored in a Handle.
inline void* system_handle(const Handle& handle) { return reinterpret_cast<void*>(handle.number); }

/// Makes a Handle that owns and closes a Windows HANDLE; empty for INVALID_HANDLE_VALUE and for a null pointer.
inline Handle owned(void* system) {
  return system == nullptr ? Handle() : Handle(reinterpret_cast<std::intptr_t>(system));
}

/// Converts an offset in a file to a Windows OVERLAPPED structure.
template <class Overlapped>
Overlapped offset(std::uint64_t place) {
  Overlapped where{};
  where.Offset = static_cast<std::uint32_t>(place);
  where.OffsetHigh = static_cast<std::uint32_t>(place >> 32U);
  return where;
}

/// Duplicates a Windows HANDLE. Child processes inherit the duplicate if `inherited` is set.
Handle copied(void* system, bool inherited = false);

/// The system's reason for the last failure in this thread.
std::error_code last_error();

/// Converts text from UTF-8 to UTF-16.
inline std::wstring wide(const std::string& text) { return std::filesystem::path(text).wstring(); }

}  // namespace coppermoon::files
