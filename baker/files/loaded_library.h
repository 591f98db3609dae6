// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::files {

/// File of the running program.
///
/// Throws  std::filesystem::filesystem_error  where the system does not tell
std::filesystem::path own_program();

/// File that some code or constant is in: the program, or a library that it has loaded.
std::filesystem::path file_that_has(const void* part);

/// Function of a library, which is loaded for good. Its other names stay its own.
///
/// Returned  none where the library has no function of that name
/// Throws    Error  "cannot be loaded", with the system's reason
void* function_of(const std::filesystem::path& library, const char* name);

}  // namespace coppermoon::files
