// SPDX-License-Identifier: MIT
#include "texture/openimageio/silence.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <mutex>

#include "texture/openimageio/image_input.h"

namespace coppermoon::texture {
namespace {

std::mutex one_at_a_time;
int silences = 0;
int kept = -1;  ///< stderr as it was before the first of them

}  // namespace

Silence::Silence() : Silence(true) {}

Silence::Silence(const std::filesystem::path& file) : Silence(!has_openexr(file)) {}

Silence::Silence(bool wanted) : wanted_(wanted) {
  if (!wanted_) return;
  const std::lock_guard alone(one_at_a_time);
  if (silences++ > 0) return;
  std::fflush(stderr);
  kept = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (kept >= 0 && nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
  if (nowhere >= 0) ::close(nowhere);
}

Silence::~Silence() {
  if (!wanted_) return;
  const std::lock_guard alone(one_at_a_time);
  if (--silences > 0) return;
  std::fflush(stderr);
  if (kept < 0) return;
  ::dup2(kept, STDERR_FILENO);
  ::close(kept);
}

}  // namespace coppermoon::texture
