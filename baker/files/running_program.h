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

/// Waits for bytes from a pipe and returns them; empty once the other end is closed.
std::string read_some(const Handle& pipe);

/// A running program. The destructor kills it.
struct RunningProgram {
  std::int64_t id = 0;
  bool leads_group = false;  ///< whether the destructor kills its whole process group

  RunningProgram() = default;
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  /// Waits until the program ends, and returns the status that waitpid reports.
  int status();
};

/// Standard streams of a program. If one is nullptr, the input is empty, or the output is discarded.
struct Streams {
  const Handle *input = nullptr, *output = nullptr, *error = nullptr;
};

/// Starts a program. Unless `program.outlives_us` is set, the system kills it when the calling thread ends, so that
/// thread must wait for it.
///
/// Throws  Error  if the program is not installed (the message names its package) or cannot be run
void start(RunningProgram& running, const Program& program, const Streams& streams);

}  // namespace coppermoon::files
