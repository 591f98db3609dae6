// SPDX-License-Identifier: MIT
#include "verbs/moon_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "surface/albedo_map.h"
#include "surface/built_in_moon.h"
#include "files/fingerprint.h"
#include "texture/read_image.h"
#include "files/whole_file.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* stellarium_map = "/usr/share/stellarium/textures/moon_4k.jpg";

}  // namespace

void add_moon_options(CLI::App& verb, MoonOptions& options) {
  add_flag(verb, "instant,--instant", options.instant,
           "ISO 8601 UTC, as 2008-02-21T03:08:26Z; or an .exr, .tx or .png that coppermoon "
           "made, to make it again")
      .required();
  add_film_moon_options(verb, options);
}

void add_film_moon_options(CLI::App& verb, MoonOptions& options) {
  add_flag(verb, "--albedo-map", options.albedo_map,
           "any image 2:1, longitude 0 in the middle; auto; built-in")
      .reads_file();
  add_flag(verb, "--photometry", options.photometry,
           "lommel-seeliger-rolo: as telescopes measured, with the opposition surge; "
           "yapo-cutler: the paper's, the same at every phase")
      .one_of({"lommel-seeliger-rolo", "yapo-cutler"});
  add_flag(verb, "--albedo-exponent", options.albedo_exponent,
           "power of the map's values, which undoes a tone curve, 0.1 to 10; without: 0.5 for "
           "Stellarium's map, 1 for any other");
  add_flag(verb, "--texture-width", options.texture_width,
           "in texels, even, 4 to 32768; without: 4096, for a frame what it can show")
      .not_negative();
  add_switch(verb, "--unshadowed", options.unshadowed, "light the Moon as if the Earth were away");
  add_light_options(verb, options.light);
}

std::string map_chosen(const MoonOptions& options) {
  if (options.albedo_map != "auto") return options.albedo_map;
  return std::filesystem::exists(stellarium_map) ? stellarium_map : "built-in";
}

void require_map(const MoonOptions& options) {
  if (!reads_map(options)) return;
  texture::require_albedo_map(map_chosen(options), options.albedo_exponent.value_or(1));
}

std::string map_contents(const MoonOptions& options) {
  const auto map = map_chosen(options);
  return map == "built-in" ? map
                           : fmt::format("{:016x}", files::fingerprint(files::bytes_of(map)));
}

surface::Photometry photometry_of(const MoonOptions& options) {
  using enum surface::Photometry;
  return options.photometry == "yapo-cutler" ? yapo_cutler : lommel_seeliger_rolo;
}

std::size_t texture_width_of(const MoonOptions& options) {
  const std::size_t width = options.texture_width.value_or(4096);
  if (width % 2 != 0)
    throw algebra::Error(
        fmt::format("texture width [texels] = {}, allowed even numbers, 4 to 32768", width));
  algebra::require_within("texture width [texels]", static_cast<double>(width), 4, 32768);
  return width;
}

bool reads_map(const MoonOptions& options) { return map_chosen(options) != "built-in"; }

algebra::Grid<float> normal_albedo(const MoonOptions& options) {
  const auto map = map_chosen(options);
  if (map == "built-in")
    return surface::normalised_to_geometric_albedo(
        surface::built_in_moon(std::max<std::size_t>(8, texture_width_of(options) / 2)),
        photometry_of(options));
  const double exponent = options.albedo_exponent.value_or(map == stellarium_map ? 0.5 : 1);
  return surface::normalised_to_geometric_albedo(
      texture::read_albedo_map(map, texture::Coding::as_file_says, exponent),
      photometry_of(options));
}

void require_place_for(const std::filesystem::path& file) {
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder))
    throw algebra::Error(fmt::format("{}: no such directory", folder.string()));
  if (std::filesystem::is_directory(file))
    throw algebra::Error(fmt::format("{}: is a directory", file.string()));
}

}  // namespace coppermoon::verbs
