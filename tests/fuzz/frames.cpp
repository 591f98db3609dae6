// SPDX-License-Identifier: MIT
// An EXR file, as develop, merge and compare read it; its first byte chooses among them.
#include <cmath>
#include <cstdlib>

#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"
#include "texture/read_image.h"
#include "uses/picture/photo_file.h"
#include "verbs/recipes/one_scene.h"

namespace {

using namespace coppermoon;

void require_of_display(const texture::Image& image, const std::filesystem::path& path,
                        std::size_t channels) {
  const auto shown = texture::windows_of(path).display;
  fuzz::require(image.width == shown.width && image.height == shown.height);
  fuzz::require(image.channels.size() == channels);
  fuzz::require(image.values.size() == image.width * image.height * channels);
}

void read(const std::filesystem::path& path, int as) {
  if (as == 0) return require_of_display(texture::read_channels(path, {"R", "G", "B"}), path, 3);
  if (as == 1) {
    verbs::require_one_scene(path, path);  // of itself
    return require_of_display(texture::read_channels(path, {"R", "G", "B", "valid"}), path, 4);
  }
  const auto light = texture::read_light(path, texture::Coding::linear);
  for (const float value : light.values) fuzz::require(std::isfinite(value));
  require_of_display(light, path, 3);
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  ::setenv("OPENIMAGEIO_THREADS", "1", 1);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  static const fuzz::ScratchFile file("frame.exr");
  const auto path = file.holding(fuzz::as_text(data + 1, size - 1));
  fuzz::done([&] { read(path, data[0] % 3); });
  return 0;
}
