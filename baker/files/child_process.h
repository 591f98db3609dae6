// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coppermoon::files {

/// Number of an open file, closed at the end.
struct FileDescriptor {
  int number = -1;

  FileDescriptor() = default;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { close(); }
  void close();
};

/// Pipe whose ends are 3 and above: a child can put its standard streams in place without closing them.
struct Pipe {
  FileDescriptor out, in;

  /// Throws  Error  when the system has none left
  Pipe();
};

/// Running program, killed by the destructor.
struct Child {
  pid_t id = 0;
  bool leads_group = false;  ///< its process group is killed with it

  Child() = default;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();

  /// Waits for the program's end.
  ///
  /// Returned  status as of waitpid
  int status();
};

/// Program as it is to be run.
struct Program {
  std::vector<std::string> words;        ///< name on the PATH or path, then the arguments
  std::string package;                   ///< Debian package that has it
  std::filesystem::path folder = ".";    ///< working directory
  std::vector<std::string> variables{};  ///< of its environment that differ from ours: "NAME=value"
  /// Goes on when we end, and leads a process group of its own: signals to ours do not reach it.
  bool outlives_us = false;
};

/// Descriptors of a program's standard streams, 3 or above; below 0: /dev/null.
struct Streams {
  int input = -1, output = -1, error = -1;
};

/// Starts a program. Unless it outlives us it ends with the calling thread, whatever ends that: the thread must
/// wait for the child.
///
/// Throws  Error  when it cannot be run: names the package when there is no such program
void start(Child& child, const Program& program, const Streams& streams);

/// Runs a program to its end.
///
/// Given   result  descriptor of the file for its standard output, 3 or above; without: /dev/null
/// Throws  Error   as start; when it fails: its own first words; when it ends well: as require_whole
void run_program(const Program& program, std::optional<int> result = {});

/// Refuses a file that a program left empty or cut off (has_its_end), whatever its exit status says.
///
/// Given  by  name of the program
void require_whole(int descriptor, const std::string& by);
void require_whole(const std::filesystem::path& file, const std::string& by);

/// Runs a program to its end.
///
/// Given     program  writes at most 4096 bytes to its standard output
/// Returned  its standard output
/// Throws    Error  as start; when it fails: its own last words
std::string output_of(const Program& program);

}  // namespace coppermoon::files
