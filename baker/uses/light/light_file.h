// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Writes light without its direct part, with its plan without the seconds of this machine; the file appears whole or
/// not at all.
///
/// Given   key    recipe of all that the light depends on
/// Throws  Error  one line with the path, when it cannot
void write_light(const std::filesystem::path& path, const std::string& key, const Moonlight& light);

/// Whether a file is light of write_light's, perhaps damaged: it begins like one, or is empty.
///
/// Throws  Error  as files::beginning_of
bool is_light(const std::filesystem::path& path);

/// Light of a file, and its key.
struct KeptLight {
  std::string key;
  Moonlight light;
};

/// Reads the light of write_light, bit by bit the same.
///
/// Returned  nothing when there is no such file, its checksum fails, or a number or length is out of bounds
/// Throws    Error  when it is a folder, a device or a pipe
std::optional<KeptLight> read_light(const std::filesystem::path& path);

}  // namespace coppermoon::uses
