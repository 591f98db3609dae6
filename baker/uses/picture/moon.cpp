// SPDX-License-Identifier: MIT
#include "uses/picture/moon.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "files/fingerprint.h"
#include "files/whole_file.h"
#include "surface/albedo_map.h"
#include "surface/built_in_moon.h"
#include "texture/read_image.h"

namespace coppermoon::uses {
namespace {

constexpr const char* stellarium_map = "/usr/share/stellarium/textures/moon_4k.jpg";

}  // namespace

std::string map_chosen(const MoonRequest& moon) {
  if (moon.albedo_map != "auto") return moon.albedo_map;
  return std::filesystem::exists(stellarium_map) ? stellarium_map : "built-in";
}

void require_map(const MoonRequest& moon) {
  if (!reads_map(moon)) return;
  texture::require_albedo_map(map_chosen(moon), moon.albedo_exponent.value_or(1));
}

std::string map_contents(const MoonRequest& moon) {
  const auto map = map_chosen(moon);
  return map == "built-in" ? map : fmt::format("{:016x}", files::fingerprint(files::bytes_of(map)));
}

std::size_t texture_width_of(const MoonRequest& moon) {
  const std::size_t width = moon.texture_width.value_or(4096);
  if (width % 2 != 0)
    throw algebra::Error(
        fmt::format("texture width [texels] = {}, allowed even numbers, 4 to 32768", width));
  algebra::require_within("texture width [texels]", static_cast<double>(width), 4, 32768);
  return width;
}

bool reads_map(const MoonRequest& moon) { return map_chosen(moon) != "built-in"; }

algebra::Grid<float> normal_albedo(const MoonRequest& moon) {
  const auto map = map_chosen(moon);
  if (map == "built-in")
    return surface::normalised_to_geometric_albedo(
        surface::built_in_moon(std::max<std::size_t>(8, texture_width_of(moon) / 2)),
        moon.photometry);
  const double exponent = moon.albedo_exponent.value_or(map == stellarium_map ? 0.5 : 1);
  return surface::normalised_to_geometric_albedo(
      texture::read_albedo_map(map, texture::Coding::as_file_says, exponent), moon.photometry);
}

}  // namespace coppermoon::uses
