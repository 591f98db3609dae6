// SPDX-License-Identifier: MIT
// A Moon in the shadow, baked to 1 % of luminance and written as a scene-linear texture.
#include <coppermoon/almanac/instant.h>
#include <coppermoon/uses/picture/baked_moon.h>

#include <cstdio>

using namespace coppermoon;

int main() {
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:21:45Z"));
  const auto moon =
      uses::lit_moon({.light = {.wish = {.tolerance = 0.01}}, .texture_width = 1024}, sky);
  const auto baked = uses::baked(moon, {.space = colour::WorkingSpace::acescg});
  texture::write_exr("moon_acescg.exr", baked.parts, baked.attributes);
  std::printf("moon_acescg.exr, error %.2g\n", moon.light->error_found);
}
