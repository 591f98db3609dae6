// SPDX-License-Identifier: MIT
// An image, read as a map or as any; that and its name's ending are chosen by its first byte.
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "fuzz/refused.h"
#include "fuzz/scratch_file.h"
#include "texture/read_image.h"

namespace {

using namespace coppermoon;

constexpr std::array endings{"exr", "tif", "png", "jpg", "pgm", "hdr"};

const fuzz::ScratchFile& file_with(std::size_t ending) {
  static std::array<std::unique_ptr<fuzz::ScratchFile>, endings.size()> files;
  auto& file = files[ending % endings.size()];
  if (!file)
    file =
        std::make_unique<fuzz::ScratchFile>(std::string("map.") + endings[ending % endings.size()]);
  return *file;
}

void read_map(const std::filesystem::path& path) {
  const auto map = texture::read_albedo_map(path);
  for (const float value : map.values()) fuzz::require(std::isfinite(value) && value >= 0);
}

void read_any(const std::filesystem::path& path) {
  const auto image = texture::read_image(path);
  fuzz::require(image.values.size() == image.width * image.height * image.channels.size());
  texture::read_attribute(path, "coppermoon:recipe");
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  ::setenv("OPENIMAGEIO_THREADS", "1", 1);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const auto path = file_with(data[0]).holding(fuzz::as_text(data + 1, size - 1));
  const bool map = data[0] / endings.size() % 2 == 0;
  fuzz::done([&] { map ? read_map(path) : read_any(path); });
  return 0;
}
