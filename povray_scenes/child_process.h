// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coppermoon::povray_scenes {

/// An open file's number, closed at the end.
struct FileDescriptor {
  int number = -1;

  FileDescriptor() = default;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { close(); }
  void close();
};

/// Its ends are 3 and above: a child can put its standard streams in place without closing them.
struct Pipe {
  FileDescriptor out, in;

  /// Throws  Error  when the system has none left
  Pipe();
};

/// A running program; killed when it is left before its end.
struct Child {
  pid_t id = 0;

  Child() = default;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// What waitpid says of its end, once that has come.
  int status();
};

/// A program as it is to be run.
struct Program {
  std::vector<std::string> words;  ///< itself, on the PATH or by its path, and its arguments
  std::string package;             ///< of Debian's that has it
  std::filesystem::path folder = ".";
  std::vector<std::string> variables =
      {};  ///< of its environment that differ from ours: "NAME=value"
};

/// Starts it, with nothing to read. It ends with the calling thread at the latest, whatever ends that: the
/// thread must wait for the child.
///
/// Given   standard_error   a descriptor, 3 or above
///         standard_output  the same; without: nobody hears it
/// Throws  Error            when it cannot be run: names the package when there is no such program
void start(Child& child, const Program& program, int standard_error,
           std::optional<int> standard_output = {});

/// Runs it to its end.
///
/// Given   result  a file's descriptor, 3 or above, as its standard output; without: nobody hears it
/// Throws  Error   as start; when it fails: its own first words; when it ends well, and the file is empty
void run_program(const Program& program, std::optional<int> result = {});

/// Runs it to its end.
///
/// Given     program  writes little to its standard output, 4096 bytes at most
/// Returned  that
/// Throws    Error  as start; when it fails: its own last words
std::string output_of(const Program& program);

}  // namespace coppermoon::povray_scenes
