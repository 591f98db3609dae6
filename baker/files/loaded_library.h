// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::files {

/// Path of the running program's file.
///
/// Throws  std::filesystem::filesystem_error  if the system does not report it
std::filesystem::path own_program();

/// File that contains a piece of code or a constant: the program, or a library that it has loaded.
std::filesystem::path file_that_has(const void* part);

/// Function in a library, which is loaded and never unloaded. The library's other symbols stay local to it.
///
/// Returned  nullptr if the library has no function of that name
/// Throws    Error  "cannot be loaded", with the system's reason
void* function_of(const std::filesystem::path& library, const char* name);

}  // namespace coppermoon::files
