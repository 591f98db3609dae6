// SPDX-License-Identifier: MIT
// What POSIX lacks; linux_posix.cpp and macos_posix.cpp each implement it for their own system.
#pragma once
#include <cstdio>
#include <filesystem>
#include <string>

#include "files/handle.h"

extern "C" char** environ;  // POSIX has it in no header

namespace coppermoon::files {

/// Makes a pipe whose ends no other program inherits; false if the system cannot.
bool make_pipe(int (&ends)[2]);

/// Has the system end this process when its parent ends; false if that has happened, or cannot be had.
bool end_with(int parent);

/// Replaces this process with a program from the path; returns only on failure.
void execute(char* const* arguments, char* const* variables);

/// Watches a folder for the closing of files written there. Returns an empty handle if `file` is empty or the system
/// cannot watch.
Handle watch(const std::filesystem::path& folder, const std::string& file);

/// Whether the pending reports of a watch include the closing of a given file.
bool has_closed(const Handle& watch, const std::string& file);

/// Makes a file without a name in a folder; an empty handle if the system cannot.
Handle nameless_file(const std::filesystem::path& folder);

/// Writes to stderr. If nothing reads stderr, the words are dropped and count as written.
std::size_t say_or_lose(const char* words, std::size_t size);

/// A stream whose words go to say_or_lose; nullptr if the system cannot make one.
FILE* stream_to_say_or_lose();

}  // namespace coppermoon::files
