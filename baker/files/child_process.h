// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "files/handle.h"

namespace coppermoon::files {

/// Program as it is to be run.
struct Program {
  std::vector<std::string> words;        ///< name on the PATH or path, then the arguments
  std::string package;                   ///< Debian package that has it
  std::filesystem::path folder = ".";    ///< working directory
  std::vector<std::string> variables{};  ///< of its environment that differ from ours: "NAME=value"
  /// Goes on when we end, and leads a process group of its own: signals to ours do not reach it.
  bool outlives_us = false;
};

/// What becomes of a program's output while it runs.
struct Hearing {
  const Handle* result = nullptr;  ///< takes its standard output; none: nothing does
  /// Told what the program says on its standard error, as it comes; may throw, which ends the program.
  std::function<void(std::string_view)> hear{};
  /// Ends the program once it has closed this file in its folder, where the system reports that; empty: never.
  std::string until_closed{};
  double timeout_s = 0;  ///< 0: none
};

/// Runs a program to its end, or for as long as it is heard. It does not outlive this call, whether that returns,
/// throws, or the process is killed.
///
/// Returned  whether it ended well, or closed that file
/// Throws    Error  when it cannot be run: names the package when there is no such program; when a signal ended it;
///                  when it takes longer than allowed
bool run_heard(const Program& program, const Hearing& hearing);

/// Runs a program to its end.
///
/// Given   result  takes its standard output; none: nothing does
/// Throws  Error   as run_heard; when it fails: its own first words; when it ends well: as require_whole
void run_program(const Program& program, const Handle* result = nullptr);

/// Refuses a file that a program left empty or cut off (has_its_end), whatever its exit status says.
///
/// Given  by  name of the program
void require_whole(const Handle& file, const std::string& by);

/// Runs a program to its end.
///
/// Given     program  writes at most 4096 bytes to its standard output
/// Returned  its standard output
/// Throws    Error  as run_heard; when it fails: its own last words
std::string output_of(const Program& program);

/// Name by which a program can open its standard output, to go back in it as a pipe cannot.
extern const char* const own_output;

}  // namespace coppermoon::files
