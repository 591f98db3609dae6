// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace coppermoon::files {

/// The operating system's number for an open file, one end of a pipe, or a lock. The destructor closes it.
struct Handle {
  std::intptr_t number = -1;  ///< negative if nothing is open

  Handle() = default;
  explicit Handle(std::intptr_t opened) : number(opened) {}
  Handle(Handle&& other) noexcept : number(std::exchange(other.number, -1)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(number, other.number);
    return *this;
  }
  ~Handle() { close(); }
  void close();

  explicit operator bool() const { return number >= 0; }
};

/// Opens a file for reading. Returns an empty handle on failure, and never blocks, even on a pipe without a writer.
Handle opened(const std::filesystem::path& file);

/// Size of an open file [bytes]; 0 for a folder, a pipe or a device.
std::uint64_t size_of(const Handle& file);

/// Reads `count` bytes of a file, starting at the offset `place`; fewer if the file ends first.
std::string bytes_at(const Handle& file, std::uint64_t place, std::size_t count);

/// Writes bytes into a file, starting at the offset `place`.
///
/// Returned  the system's error if not all bytes could be written
std::error_code write_at(const Handle& file, std::uint64_t place, std::string_view bytes);

/// Path by which this process can open the file again, even if the file has no name in any folder yet.
std::string name_of(const Handle& file);

}  // namespace coppermoon::files
