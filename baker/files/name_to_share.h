// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace coppermoon::files {

/// Name of a file without the user's private folders, for files that are passed on to others.
///
/// Returned  relative names and /usr/… unchanged; absolute names within the current folder relative to it; the
///           file name alone for all other names
std::string name_to_share(const std::filesystem::path& path);

/// Path of a file that a shared file names: in the current folder if it is there, else beside the shared file.
std::string shared_file(const std::string& name, const std::filesystem::path& named_in);

}  // namespace coppermoon::files
