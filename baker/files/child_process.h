// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "files/handle.h"

namespace coppermoon::files {

/// A program to run, and how to run it.
struct Program {
  std::vector<std::string> words;        ///< the program's name or path, then its arguments
  std::string package;                   ///< Debian package that contains it
  std::filesystem::path folder = ".";    ///< working directory
  std::vector<std::string> variables{};  ///< environment variables to set or replace: "NAME=value"
  /// Keeps running after this process ends, in a process group of its own, so that signals to ours do not reach it.
  bool outlives_us = false;
};

/// What to do with a program's output while it runs, and when to end it.
struct Hearing {
  const Handle* result = nullptr;  ///< receives its standard output; nullptr: discarded
  /// Receives the program's standard error as it is written. May throw, which ends the program.
  std::function<void(std::string_view)> hear{};
  /// File in the program's folder: once the program closes it, the program is ended, if the system reports it. If
  /// empty, never.
  std::string until_closed{};
  double timeout_s = 0;  ///< 0: no timeout
};

/// Runs a program until it ends or `hearing` ends it. The program never outlives this call, even if the call throws or
/// this process is killed.
///
/// Returned  whether the program ended successfully or closed the file `until_closed`
/// Throws    Error  if the program cannot be run: names the package if there is no such program; if a signal ended
///                  it; if it exceeds the timeout
bool run_heard(const Program& program, const Hearing& hearing);

/// Runs a program to its end.
///
/// Given   result  receives its standard output; nullptr: discarded
/// Throws  Error   as run_heard; if the program fails, with the first words of its own message; if it succeeds, as
///                 require_whole
void run_program(const Program& program, const Handle* result = nullptr);

/// Refuses a file that a program left empty or truncated (has_its_end), whatever its exit status.
///
/// Given  by  the program's name
void require_whole(const Handle& file, const std::string& by);

/// Runs a program to its end.
///
/// Given     program  writes at most 4096 bytes to its standard output
/// Returned  its standard output
/// Throws    Error  as run_heard; if the program fails, with the last words of its own message
std::string output_of(const Program& program);

/// Name by which a program can open its standard output as a file in which it can seek.
extern const char* const own_output;

}  // namespace coppermoon::files
