// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace coppermoon::files {

/// Name under which to mention a file in other files that are passed on: without the user's private folders.
///
/// Returned  relative names and names in /usr unchanged; absolute names in the current folder relative to it; for all
///           other names, only the last part
std::string name_to_share(const std::filesystem::path& path);

/// Path of a file that a shared file mentions: in the current folder if it exists there, else beside the shared file.
std::string shared_file(const std::string& name, const std::filesystem::path& named_in);

}  // namespace coppermoon::files
