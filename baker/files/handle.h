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

/// Number by which the system knows an open file, a pipe's end or a lock; closed by the destructor.
struct Handle {
  std::intptr_t number = -1;  ///< below 0: none

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

/// File opened for reading; none where that cannot be. It never waits, also for a pipe without a writer.
Handle opened(const std::filesystem::path& file);

/// Size of an open file [bytes]; 0 of a folder, a pipe or a device.
std::uint64_t size_of(const Handle& file);

/// Bytes of a file from a place on; fewer where it ends before.
std::string bytes_at(const Handle& file, std::uint64_t place, std::size_t count);

/// Writes bytes at a place of a file.
///
/// Returned  the system's reason where some could not be written
std::error_code write_at(const Handle& file, std::uint64_t place, std::string_view bytes);

/// Name by which this process can open the file again, also where it has no name in a folder yet.
std::string name_of(const Handle& file);

}  // namespace coppermoon::files
