// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace coppermoon::files {

/// Variable of this process's environment; empty where there is none.
std::string variable(const char* name);

/// Sets a variable of the environment unless it is there.
void set_missing_variable(const char* name, const std::string& value);

/// Folder of the user's caches, as the XDG Base Directory Specification has it; empty when the user has no home.
std::filesystem::path users_caches();

/// Whether a path, and its target if it is a link, belong to this user or to the administrator.
bool belongs_to_user(const std::filesystem::path& path);

/// Makes a folder that its user alone may enter; one that is there stays as it is.
///
/// Returned  the system's reason where it cannot be made
std::error_code make_folder_for_user(const std::filesystem::path& folder);

}  // namespace coppermoon::files
