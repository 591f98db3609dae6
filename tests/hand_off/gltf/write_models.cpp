// SPDX-License-Identifier: MIT
// Writes moon.glb and moon.usda into the folder named, for other programs to read. Each texel of the picture tells its
// place: red from west to east, green from north to south.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "texture/write_glb.h"
#include "texture/write_image.h"
#include "texture/write_usda.h"

int main(int, char** arguments) try {
  using namespace coppermoon::texture;
  const std::filesystem::path folder = arguments[1];
  Image picture(1024, 512, {"R", "G", "B"});
  for (std::size_t r = 0; r < picture.height; ++r)
    for (std::size_t c = 0; c < picture.width; ++c) {
      picture(r, c, 0) = (static_cast<float>(c) + 0.5F) / 1024;
      picture(r, c, 1) = (static_cast<float>(r) + 0.5F) / 512;
    }
  write_glb(folder / "moon.glb", picture, "coppermoon 0.0.0");
  write_exr(folder / "moon_lin_rec709.exr", picture, {});
  write_usda(folder / "moon.usda", "moon_lin_rec709.exr", "lin_rec709_scene");
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
