// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "files/child_process.h"
#include "files/handle.h"

namespace coppermoon::files {

/// Pipe whose ends a child process can use as its standard streams.
struct Pipe {
  Handle out, in;

  /// Throws  Error  if the system cannot provide another pipe
  Pipe();
};

/// Waits for bytes from a pipe and returns them; empty at the pipe's end.
std::string read_some(const Handle& pipe);

/// Running program, killed by the destructor.
struct RunningProgram {
  std::int64_t id = 0;
  bool leads_group = false;  ///< whether its process group is killed with it

  RunningProgram() = default;
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  /// Waits for the program's end.
  ///
  /// Returned  the exit status as the system reports it
  int status();
};

/// Standard streams of a program; nullptr: an empty input, or output that is discarded.
struct Streams {
  const Handle *input = nullptr, *output = nullptr, *error = nullptr;
};

/// Starts a program. Unless it outlives us, it ends when the calling thread ends, for whatever reason. The thread
/// must therefore wait for it.
///
/// Throws  Error  if the program cannot be run: names the package if there is no such program
void start(RunningProgram& running, const Program& program, const Streams& streams);

}  // namespace coppermoon::files
