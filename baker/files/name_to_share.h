// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace coppermoon::files {

/// A file's name as it may stand in a file for others: no folder of the user's own.
///
/// Returned  a relative name as it is; of an absolute one what follows the current folder, where it is in
///           it; /usr/… as it is; of any other the bare name
std::string name_to_share(const std::filesystem::path& path);

/// Where a file stands that a shared file names: beside that file, unless one is in the current folder.
std::string shared_file(const std::string& name, const std::filesystem::path& named_in);

}  // namespace coppermoon::files
