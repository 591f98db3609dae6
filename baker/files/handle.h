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

/// The system's number for an open file, an end of a pipe, or a lock; closed by the destructor.
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

/// Opens a file for reading; an empty handle if that fails. Never blocks, even on a pipe without a writer.
Handle opened(const std::filesystem::path& file);

/// Size of an open file [bytes]; 0 for a folder, a pipe or a device.
std::uint64_t size_of(const Handle& file);

/// Reads `count` bytes of a file from an offset on; fewer if the file ends first.
std::string bytes_at(const Handle& file, std::uint64_t place, std::size_t count);

/// Writes bytes at an offset in a file.
///
/// Returned  the system's reason if some bytes could not be written
std::error_code write_at(const Handle& file, std::uint64_t place, std::string_view bytes);

/// Name by which this process can open the file again, even if the file has no name in a folder yet.
std::string name_of(const Handle& file);

}  // namespace coppermoon::files
