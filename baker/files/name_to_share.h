// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace coppermoon::files {

/// A file's name without the user's private folders, for use in files that may be given to others.
///
/// Returned  relative paths and paths in /usr unchanged, but with slashes instead of backslashes on Windows; absolute
///           paths in the current folder relative to it; only the file's own name for all other paths
std::string name_to_share(const std::filesystem::path& path);

/// Finds a file that another file mentions: in the current folder if it exists there, else beside the other file.
std::string shared_file(const std::string& name, const std::filesystem::path& named_in);

}  // namespace coppermoon::files
