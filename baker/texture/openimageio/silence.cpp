// SPDX-License-Identifier: MIT
#include "texture/openimageio/silence.h"

#include <mutex>

#include "files/standard_streams.h"
#include "texture/openimageio/image_input.h"

namespace coppermoon::texture {
namespace {

std::mutex one_at_a_time;
int silences = 0;
files::Handle kept;  ///< stderr as it was before the first Silence

}  // namespace

Silence::Silence() : Silence(true) {}

Silence::Silence(const std::filesystem::path& file) : Silence(!has_openexr(file)) {}

Silence::Silence(bool wanted) : wanted_(wanted) {
  if (!wanted_) return;
  const std::lock_guard alone(one_at_a_time);
  if (silences++ > 0) return;
  kept = files::silence_errors();
}

Silence::~Silence() {
  if (!wanted_) return;
  const std::lock_guard alone(one_at_a_time);
  if (--silences > 0) return;
  files::hear_errors(kept);
  kept.close();
}

}  // namespace coppermoon::texture
