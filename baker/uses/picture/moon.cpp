// SPDX-License-Identifier: MIT
#include "uses/picture/moon.h"

#include <fmt/format.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algebra/error.h"
#include "colour/camera_spectra.h"
#include "files/fingerprint.h"
#include "files/whole_file.h"
#include "surface/albedo_map.h"
#include "surface/built_in_map.h"
#include "texture/read_image.h"
#include "texture/resize.h"
#include "texture/seal.h"
#include "uses/light/spectral_bands.h"

namespace coppermoon::uses {
namespace {

void require_sound(const MoonRequest& moon) {
  algebra::require_within("albedo exponent", moon.albedo_exponent, 0.1, 10);
  if (const int centre = moon.albedo_map_centre_deg; centre != 0 && centre != 180)
    throw algebra::Error(
        fmt::format("albedo map's centre [degrees] = {}, allowed 0 or 180", centre));
  if (moon.response) colour::require_spectral(*moon.response);
}

/// Rotates a map that has longitude 180 in its middle by half a turn, which brings longitude 0 to the middle.
void turn_round(algebra::Grid<float>& map) {
  for (std::size_t r = 0; r < map.rows(); ++r)
    std::rotate(map.row(r).begin(), map.row(r).begin() + map.columns() / 2, map.row(r).end());
}

/// Ratio of the mean albedo of a map's near side to that of its far side.
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

template <class Change>
void change(algebra::Grid<float>& map, const Change& changed) {
  tbb::parallel_for(std::size_t{0}, map.rows(), [&](std::size_t r) {
    for (float& value : map.row(r)) value = static_cast<float>(changed(static_cast<double>(value)));
  });
}

void raise_to(double exponent, algebra::Grid<float>& map) {
  change(map, [=](double value) { return std::pow(value, exponent); });
}

using Map = algebra::Grid<float>;

Map as_it_is(Map map) { return map; }

Map of_kit_2019(Map map) {
  change(map, surface::kit_2019_albedo);
  return surface::with_polar_contrast(std::move(map));
}

Map of_kit_2025(Map map) {
  raise_to(surface::exponent_to_full_moon, map);
  return map;
}

/// How a file's numbers are read, and how they are then converted to normal albedo.
struct Decoding {
  AlbedoEncodingWord word;
  texture::Coding coding;
  Map (*decoded)(Map);
};

// To add an encoding, add a row here and a row in docs/textures.md.
const std::vector<Decoding> decodings{
    {{"image", AlbedoEncoding::image, "light, as the file says"},
     texture::Coding::as_file_says,
     as_it_is},
    {{"normal-albedo", AlbedoEncoding::normal_albedo, "the numbers themselves"},
     texture::Coding::linear,
     as_it_is},
    {{"cgi-moon-kit-2019", AlbedoEncoding::cgi_moon_kit_2019, "NASA's colour map of 2019"},
     texture::Coding::linear,
     of_kit_2019},
    {{"cgi-moon-kit-2025", AlbedoEncoding::cgi_moon_kit_2025, "NASA's of 2025"},
     texture::Coding::srgb,
     of_kit_2025}};

Map decoded_map(const std::filesystem::path& file, AlbedoEncoding encoding) {
  const auto& how = *std::ranges::find(
      decodings, encoding, [](const Decoding& decoding) { return decoding.word.encoding; });
  return how.decoded(texture::read_albedo_map(file, how.coding));
}

/// The built-in map. If it is finer than the texture, it is averaged down to the texture's size.
algebra::Grid<float> built_in_map_for(const MoonRequest& moon) {
  auto map = surface::built_in_map();
  const std::size_t rows = texture_width_of(moon) / 2;
  return rows < map.rows() ? texture::resized(map, rows) : map;
}

}  // namespace

std::vector<AlbedoEncodingWord> albedo_encoding_words() {
  std::vector<AlbedoEncodingWord> words;
  for (const auto& decoding : decodings) words.push_back(decoding.word);
  return words;
}

void require_map(const MoonRequest& moon) {
  require_sound(moon);
  if (!reads_map(moon)) return;
  texture::require_albedo_map(moon.albedo_map);
}

std::string map_contents(const MoonRequest& moon) {
  if (moon.response && moon.response->ends_with(".csv")) {
    auto of_map = moon;
    of_map.response.reset();
    return fmt::format("{} {:016x}", map_contents(of_map),
                       files::fingerprint(files::bytes_of(*moon.response)));
  }
  const auto& map = moon.albedo_map;
  if (!reads_map(moon)) return map;
  auto contents = fmt::format("{:016x}", files::fingerprint(files::bytes_of(map)));
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

bool reads_map(const MoonRequest& moon) { return moon.albedo_map != "built-in"; }

algebra::Grid<float> normal_albedo(const MoonRequest& moon) {
  require_sound(moon);
  if (!reads_map(moon))
    return surface::normalised_to_geometric_albedo(built_in_map_for(moon), moon.photometry);
  auto albedo = decoded_map(moon.albedo_map, moon.albedo_encoding);
  if (moon.albedo_map_centre_deg != 0) turn_round(albedo);
  if (moon.albedo_exponent != 1) raise_to(moon.albedo_exponent, albedo);
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

algebra::Grid<double> of_ground(const surface::Ground* ground, const algebra::Grid<double>& weights,
                                std::span<const double> at_nm) {
  return ground ? reddest_and_bluest(weights, at_nm) : weights;
}

}  // namespace coppermoon::uses
