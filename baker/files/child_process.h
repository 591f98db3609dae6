// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "files/handle.h"

namespace coppermoon::files {

/// A program to run, with its arguments and environment.
struct Program {
  std::vector<std::string> words;        ///< the program's name or path, then its arguments
  std::string package;                   ///< Debian package that contains the program
  std::filesystem::path folder = ".";    ///< working directory
  std::vector<std::string> variables{};  ///< environment variables to set, as "NAME=value"
  /// The program keeps running when this process ends, and signals sent to this process's group do not reach it.
  bool outlives_us = false;
};

/// What to do with a program's output, and when to stop the program.
struct Hearing {
  const Handle* result = nullptr;  ///< receives the program's standard output; nullptr discards it
  /// Receives what the program writes to its standard error. If this function throws, the program is ended.
  std::function<void(std::string_view)> hear{};
  /// Name of a file in the program's working directory. Once the program closes this file, the program is killed, if
  /// the system can report the closing. If empty, the program runs to its end.
  std::string until_closed{};
  double timeout_s = 0;  ///< 0 means no timeout
};

/// Runs a program until it ends by itself or is stopped as `hearing` specifies. The program never outlives this call,
/// even if the call throws or this process is killed.
///
/// Returned  whether the program succeeded or closed the file `hearing.until_closed`
/// Throws    Error  if the program is not installed (the message names its package) or cannot be run; if a signal
///                  ended it; if it exceeds the timeout
bool run_heard(const Program& program, const Hearing& hearing);

/// Runs a program to its end.
///
/// Given   result  receives the program's standard output; nullptr discards it
/// Throws  Error   as for run_heard; also if the program fails, with the first line of its messages, or if its output
///                 is empty or incomplete
void run_program(const Program& program, const Handle* result = nullptr);

/// Throws if a program left a file empty or truncated (has_its_end), even if the program reported success.
///
/// Given   by     name of the program that wrote the file
/// Throws  Error
void require_whole(const Handle& file, const std::string& by);

/// Runs a program to its end and returns what it wrote to its standard output.
///
/// Given   program  must not write more than 4096 bytes
/// Throws  Error    as for run_heard; also if the program fails, with the last line of its messages
std::string output_of(const Program& program);

/// Path with which a program can open its own standard output as a seekable file.
///
/// Given  result  the file that run_program receives for the program's output
std::string own_output(const Handle& result);

/// Location at which a program's installer for Windows puts the program.
struct Installation {
  std::string file, folder;  ///< the program's file, and its folder in "Program Files"
};

/// On Windows, finds a program in PATH or where its installer puts it. Otherwise or on failure, returns `name`.
std::string program_file(const std::string& name, const Installation& windows = {});

}  // namespace coppermoon::files
