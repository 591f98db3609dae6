// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cstdio>

#include "files/descriptor_posix.h"
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
  cookie_io_functions_t voice{};
  voice.write = [](void*, const char* words, std::size_t size) -> ssize_t {
    const auto heard = ::write(STDERR_FILENO, words, size);
    return heard > 0 ? heard : static_cast<ssize_t>(size);
  };
  FILE* const error = ::fopencookie(nullptr, "w", voice);
  if (error == nullptr) return;
  std::setvbuf(error, nullptr, _IONBF, 0);
  stderr = error;
}

}  // namespace

void prepare_standard_streams() {
  hold_standard_descriptors();
  speak_to_whoever_hears();
  ::signal(SIGXFSZ, SIG_IGN);
}

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
