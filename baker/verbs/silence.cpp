// SPDX-License-Identifier: MIT
#include "verbs/silence.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace coppermoon::verbs {

Silence::Silence() : kept_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
  std::fflush(stderr);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (kept_ < 0 || nowhere < 0) return;
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

Silence::~Silence() {
  std::fflush(stderr);
  if (kept_ < 0) return;
  ::dup2(kept_, STDERR_FILENO);
  ::close(kept_);
}

}  // namespace coppermoon::verbs
