// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace coppermoon::files {

/// Name of a file without the user's own folders, for files that others get.
///
/// Returned  a relative name as it is; an absolute one relative to the current folder, where the file is in it;
///           /usr/… as it is; of any other the file name alone
std::string name_to_share(const std::filesystem::path& path);

/// Path of a file that a shared file names: in the current folder if it is there, else beside the shared file.
std::string shared_file(const std::string& name, const std::filesystem::path& named_in);

}  // namespace coppermoon::files
