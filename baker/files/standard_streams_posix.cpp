// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>

#include "files/descriptor_posix.h"
#include "files/linux_or_macos.h"
#include "files/standard_streams.h"

namespace coppermoon::files {
namespace {

/// Opens /dev/null on each standard descriptor that is closed. Input is opened for writing and output for reading, so
/// that using them still fails.
void hold_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0)
      ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

void speak_to_whoever_hears() {
  FILE* const error = stream_to_say_or_lose();
  if (error == nullptr) return;
  std::setvbuf(error, nullptr, _IONBF, 0);
  stderr = error;
}

}  // namespace

std::size_t say_or_lose(const char* words, std::size_t size) {
  const auto heard = ::write(STDERR_FILENO, words, size);
  return heard > 0 ? static_cast<std::size_t>(heard) : size;
}

void prepare_standard_streams() {
  hold_standard_descriptors();
  speak_to_whoever_hears();
  ::signal(SIGXFSZ, SIG_IGN);
}

int end_program(int status) { return status; }

bool errors_on_terminal() { return ::isatty(STDERR_FILENO) != 0; }

void say_at_once(std::string_view words) {
  [[maybe_unused]] const auto said = ::write(STDERR_FILENO, words.data(), words.size());
}

Handle silence_errors() {
  std::fflush(stderr);
  Handle before(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3));
  const Handle nowhere(::open("/dev/null", O_WRONLY | O_CLOEXEC));
  if (before && nowhere) ::dup2(descriptor_of(nowhere), STDERR_FILENO);
  return before;
}

void hear_errors(const Handle& before) {
  std::fflush(stderr);
  if (before) ::dup2(descriptor_of(before), STDERR_FILENO);
}

}  // namespace coppermoon::files
