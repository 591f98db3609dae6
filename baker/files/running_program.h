// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "files/child_process.h"
#include "files/handle.h"

namespace coppermoon::files {

/// Pipe whose ends a child can put in the place of its standard streams.
struct Pipe {
  Handle out, in;

  /// Throws  Error  when the system has none left
  Pipe();
};

/// Some bytes of a pipe, when there are; none at its end.
std::string read_some(const Handle& pipe);

/// Running program, killed by the destructor.
struct RunningProgram {
  std::int64_t id = 0;
  bool leads_group = false;  ///< its process group is killed with it

  RunningProgram() = default;
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;
  ~RunningProgram();

  /// Waits for the program's end.
  ///
  /// Returned  the system's account of it
  int status();
};

/// Standard streams of a program; none: nothing is read or written there.
struct Streams {
  const Handle *input = nullptr, *output = nullptr, *error = nullptr;
};

/// Starts a program. Unless it outlives us it ends with the calling thread, whatever ends that: the thread must
/// wait for it.
///
/// Throws  Error  when it cannot be run: names the package when there is no such program
void start(RunningProgram& running, const Program& program, const Streams& streams);

}  // namespace coppermoon::files
