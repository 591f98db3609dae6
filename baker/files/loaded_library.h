// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace coppermoon::files {

/// Path of the running program's file.
///
/// Throws  std::filesystem::filesystem_error  if the system does not report the path
std::filesystem::path own_program();

/// The file from which a function or constant was loaded: the program itself or one of its libraries.
std::filesystem::path file_that_has(const void* part);

/// Loads a library and finds a function in it. The library is never unloaded, and its symbols stay local to it.
///
/// Returned  nullptr if the library has no function of that name
/// Throws    Error  if the library cannot be loaded, with the system's reason
void* function_of(const std::filesystem::path& library, const char* name);

}  // namespace coppermoon::files
