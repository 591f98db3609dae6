// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Writes light and its plan to a file, but neither direct light nor timings. The file appears whole or not at all.
///
/// Given   key    recipe with everything that the light depends on
/// Throws  Error  when the file cannot be written; the message is one line with the path
void write_light(const std::filesystem::path& path, const std::string& key, const Moonlight& light);

/// Whether a file begins like one from write_light, even if it is damaged. An empty file counts too.
///
/// Throws  Error  when the path is not that of a regular file that can be read
bool is_light(const std::filesystem::path& path);

/// Light read from a file, and the key with which it was written.
struct KeptLight {
  std::string key;
  Moonlight light;
};

/// Reads light exactly as write_light wrote it, bit for bit.
///
/// Returned  nothing when there is no such file, its checksum fails, or a number or length is out of bounds
/// Throws    Error  when the path is a folder, a device or a pipe
std::optional<KeptLight> read_light(const std::filesystem::path& path);

}  // namespace coppermoon::uses
