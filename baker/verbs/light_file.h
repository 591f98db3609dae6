// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "verbs/light_options.h"

namespace coppermoon::verbs {

/// Writes light that was computed, but for its direct part, with its plan, but for what it takes on
/// this machine; the file appears whole or not at all.
///
/// Given   key    of all that it depends on
/// Throws  Error  one line with the path, when it cannot
void write_light(const std::filesystem::path& path, const std::string& key, const Moonlight& light);

/// Reads it again, bit by bit the same.
///
/// Returned  nothing when there is no such file, it was written for another key or by another
///           version, or it is not, byte by byte, what was written
std::optional<Moonlight> read_light(const std::filesystem::path& path, const std::string& key);

}  // namespace coppermoon::verbs
