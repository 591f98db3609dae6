// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace coppermoon::files {

/// Value of an environment variable; empty if it is not set.
std::string variable(const char* name);

/// Sets an environment variable unless it is already set.
void set_missing_variable(const char* name, const std::string& value);

/// The user's cache folder according to the XDG Base Directory Specification; empty if the user has no home folder.
std::filesystem::path users_caches();

/// Whether a file or folder belongs to this user or to root. If it is a link, its target must belong to them too.
bool belongs_to_user(const std::filesystem::path& path);

/// Makes a folder that only this user may enter. An existing folder is left as it is.
///
/// Returned  the system's reason if the folder cannot be made
std::error_code make_folder_for_user(const std::filesystem::path& folder);

}  // namespace coppermoon::files
