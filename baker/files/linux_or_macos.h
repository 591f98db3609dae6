// SPDX-License-Identifier: MIT
// Functions that POSIX lacks. linux_posix.cpp and macos_posix.cpp each implement them for one system.
#pragma once
#include <cstdio>
#include <filesystem>
#include <string>

#include "files/handle.h"

extern "C" char** environ;  // declared here, because no POSIX header declares it

namespace coppermoon::files {

/// Makes a pipe whose ends are not inherited by programs that this process runs. Returns false on failure.
bool make_pipe(int (&ends)[2]);

/// Asks the system to end this process when its parent ends. Returns false if that fails or the parent has ended.
bool end_with(int parent);

/// Replaces this process with a program found in PATH; returns only on failure.
void execute(char* const* arguments, char* const* variables);

/// Watches a folder to learn when a file that was written there is closed. Returns an empty handle if `file` is empty
/// or the system cannot watch folders.
Handle watch(const std::filesystem::path& folder, const std::string& file);

/// Whether the pending notifications of a watch include the closing of a given file.
bool has_closed(const Handle& watch, const std::string& file);

/// Makes a file without a name in a folder. Returns an empty handle if the system cannot make such a file.
Handle nameless_file(const std::filesystem::path& folder);

/// Writes to stderr. If nothing reads stderr, the text is dropped but counts as written.
std::size_t say_or_lose(const char* words, std::size_t size);

/// A stream that passes its text to say_or_lose; nullptr if the system cannot make such a stream.
FILE* stream_to_say_or_lose();

}  // namespace coppermoon::files
