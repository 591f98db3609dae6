// SPDX-License-Identifier: MIT
#pragma once

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace coppermoon {

/// What a program that we run comes to when we are killed.
///
/// Given     pid_file  that program writes its process's number into it
///           run       runs the program, and waits for it
/// Returned  the signal that ended it; 0 when it ended by itself
template <class Run>
int signal_after_our_death(const std::filesystem::path& pid_file, Run run) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans become ours, to wait for
  const pid_t ourselves = ::fork();
  if (ourselves == 0) {
    run();
    ::_exit(0);
  }
  while (!std::filesystem::exists(pid_file) && ::waitpid(ourselves, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  pid_t program = 0;
  std::ifstream(pid_file) >> program;
  ::kill(ourselves, SIGKILL);
  ::waitpid(ourselves, nullptr, 0);
  int status = 0;
  if (program <= 0 || ::waitpid(program, &status, 0) != program) return -1;
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace coppermoon
