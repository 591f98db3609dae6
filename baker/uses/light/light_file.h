// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Writes light that was computed, but for its direct part, with its plan, but for what it takes on
/// this machine; the file appears whole or not at all.
///
/// Given   key    of all that it depends on
/// Throws  Error  one line with the path, when it cannot
void write_light(const std::filesystem::path& path, const std::string& key, const Moonlight& light);

/// Whether a file is light that write_light left, or was so before it was damaged: it begins as such, or is
/// empty.
///
/// Throws  Error  as files::beginning_of
bool is_light(const std::filesystem::path& path);

/// Light that was read, and the key it was written for.
struct KeptLight {
  std::string key;
  Moonlight light;
};

/// Reads it again, bit by bit the same.
///
/// Returned  nothing when there is no such file, or it is not, byte by byte, what was written, or not
///           what any light is: each number within its bounds, each list of its length
/// Throws    Error  when it is a folder, a device or a pipe
std::optional<KeptLight> read_light(const std::filesystem::path& path);

}  // namespace coppermoon::uses
