// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "algebra/error.h"
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
  Handle
      tree{};  ///< a job object on Windows; closing this handle kills the program and its children
  bool leads_group = false;  ///< whether the destructor kills the program's process group

  RunningProgram() = default;
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  /// Waits until the program ends, and returns the status that the system reports.
  int status();
};

/// Error for a program that has not ended within its timeout.
algebra::Error not_done(const Program& program, double timeout_s);

/// Standard streams of a program. An input that is nullptr is empty; an output that is nullptr is discarded.
struct Streams {
  const Handle *input = nullptr, *output = nullptr, *error = nullptr;
};

/// Starts a program. Unless `program.outlives_us` is set, the system kills it when the calling thread ends, so that
/// thread must wait for it.
///
/// Throws  Error  if the program is not installed (the message names its package) or cannot be run
void start(RunningProgram& running, const Program& program, const Streams& streams);

}  // namespace coppermoon::files
