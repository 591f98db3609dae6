// SPDX-License-Identifier: MIT
#include "uses/picture/moon.h"

#include <fmt/format.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algebra/error.h"
#include "files/fingerprint.h"
#include "files/whole_file.h"
#include "surface/albedo_map.h"
#include "surface/built_in_moon.h"
#include "texture/read_image.h"
#include "texture/seal.h"

namespace coppermoon::uses {
namespace {

constexpr const char* stellarium_map = "/usr/share/stellarium/textures/moon_4k.jpg";

/// From the radiance factor at 60 degrees of phase to that at full Moon: of ground that is darker by
/// a factor there, the logarithm of the factor is this part here. A line through all cells of Sato et
/// al. (2014), weighted by area.
constexpr double at_full_moon = 1 / 1.56;

AlbedoEncoding encoding_of(const MoonRequest& moon, const std::string& map) {
  if (moon.albedo_encoding) return *moon.albedo_encoding;
  return map == stellarium_map ? AlbedoEncoding::cgi_moon_kit_2019 : AlbedoEncoding::image;
}

texture::Coding coding_of(AlbedoEncoding encoding) {
  switch (encoding) {
    case AlbedoEncoding::image:
      return texture::Coding::as_file_says;
    case AlbedoEncoding::cgi_moon_kit_2025:
      return texture::Coding::srgb;
    default:
      return texture::Coding::linear;
  }
}

void require_sound(const MoonRequest& moon) {
  algebra::require_within("albedo exponent", moon.albedo_exponent, 0.1, 10);
  if (const int centre = moon.albedo_map_centre_deg; centre != 0 && centre != 180)
    throw algebra::Error(
        fmt::format("albedo map's centre [degrees] = {}, allowed 0 or 180", centre));
}

/// A map with longitude 180 in its middle, turned to have longitude 0 there.
void turn_round(algebra::Grid<float>& map) {
  for (std::size_t r = 0; r < map.rows(); ++r)
    std::rotate(map.row(r).begin(), map.row(r).begin() + map.columns() / 2, map.row(r).end());
}

/// The mean of a map's near side over that of its far side.
double near_over_far(const algebra::Grid<float>& map) {
  double near = 0, far = 0;
  const std::size_t columns = map.columns();
  for (std::size_t r = 0; r < map.rows(); ++r) {
    const auto row = map.row(r);
    const double all = std::reduce(row.begin(), row.end(), 0.);
    const auto west = row.begin() + columns / 4;
    const double middle = std::reduce(west, west + columns / 2, 0.);
    const double area =
        std::cos(algebra::in_radians(surface::texel_centre(r, 0, map.rows()).latitude));
    near += area * middle, far += area * (all - middle);
  }
  return near / far;
}

void change(algebra::Grid<float>& map, double offset, double scale, double exponent) {
  tbb::parallel_for(std::size_t{0}, map.rows(), [&](std::size_t r) {
    for (float& value : map.row(r))
      value = static_cast<float>(std::pow(offset + scale * static_cast<double>(value), exponent));
  });
}

algebra::Grid<float> decoded(algebra::Grid<float> map, AlbedoEncoding encoding) {
  if (encoding == AlbedoEncoding::cgi_moon_kit_2025) change(map, 0, 1, at_full_moon);
  if (encoding != AlbedoEncoding::cgi_moon_kit_2019) return map;
  change(map, 0.16, 0.24, 2.8 * at_full_moon);
  return surface::with_polar_contrast(std::move(map));
}

}  // namespace

std::string map_chosen(const MoonRequest& moon) {
  if (moon.albedo_map != "auto") return moon.albedo_map;
  return std::filesystem::exists(stellarium_map) ? stellarium_map : "built-in";
}

void require_map(const MoonRequest& moon) {
  if (!reads_map(moon)) return;
  require_sound(moon);
  texture::require_albedo_map(map_chosen(moon));
}

std::string map_contents(const MoonRequest& moon) {
  const auto map = map_chosen(moon);
  if (map == "built-in") return map;
  const auto contents = fmt::format("{:016x}", files::fingerprint(files::bytes_of(map)));
  if (std::filesystem::path(map).extension() != ".eclipse") return contents;
  return contents + texture::read_attribute(map, texture::seal_attribute).value_or("");
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
  require_sound(moon);
  const auto encoding = encoding_of(moon, map);
  auto albedo = decoded(texture::read_albedo_map(map, coding_of(encoding)), encoding);
  if (moon.albedo_map_centre_deg != 0) turn_round(albedo);
  if (moon.albedo_exponent != 1) change(albedo, 0, 1, moon.albedo_exponent);
  constexpr double as_it_should_be = 1.03, no_moon = 3;
  if (const double ratio = near_over_far(albedo);
      moon.when_near_side_brighter && ratio > as_it_should_be && ratio < no_moon)
    moon.when_near_side_brighter(ratio);
  return surface::normalised_to_geometric_albedo(std::move(albedo), moon.photometry);
}

std::shared_ptr<const surface::Ground> ground_of(const MoonRequest& moon,
                                                 const algebra::Grid<float>& normal_albedo) {
  if (!moon.ground_by_place) return nullptr;
  return std::make_shared<const surface::Ground>(
      surface::ground_under(normal_albedo, moon.photometry));
}

}  // namespace coppermoon::uses
