// SPDX-License-Identifier: MIT
#include "verbs/moon_options.h"

#include <tbb/task_group.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "algebra/error.h"
#include "surface/albedo_map.h"
#include "surface/built_in_moon.h"
#include "texture/bake.h"
#include "texture/read_image.h"
#include "verbs/progress_bar.h"
#include "verbs/silence.h"
#include "verbs/spectral_bands.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* stellarium_map = "/usr/share/stellarium/textures/moon_4k.jpg";

/// What "auto" stands for here.
std::string map_chosen(const MoonOptions& options) {
  if (options.albedo_map != "auto") return options.albedo_map;
  return std::filesystem::exists(stellarium_map) ? stellarium_map : "built-in";
}

/// "2008-02-21T03:08:26Z" as OpenEXR writes it: "2008:02:21 03:08:26".
std::string capture_date(const almanac::Instant& instant) {
  std::string text = almanac::utc_text(instant).substr(0, 19);
  std::replace(text.begin(), text.end(), '-', ':');
  std::replace(text.begin(), text.end(), 'T', ' ');
  return text;
}

std::vector<std::string> channel_names(colour::WorkingSpace space) {
  if (space == colour::WorkingSpace::ciexyz_d65) return {"X", "Y", "Z"};
  return {"R", "G", "B"};
}

texture::Attributes header(const MoonOptions& options, const almanac::SkyState& sky,
                           colour::WorkingSpace space, const std::string& recipe, double error) {
  const auto xy = colour::chromaticities(space);
  return {{"chromaticities", std::vector<float>(xy.begin(), xy.end())},
          {"whiteLuminance", 1.F},
          {"capDate", capture_date(sky.when)},
          {"utcOffset", 0.F},
          {"coppermoon:version", std::string(COPPERMOON_VERSION)},
          {"coppermoon:colour_space", std::string(colour::name(space))},
          {"coppermoon:unit", std::string("cd/m^2")},
          {"coppermoon:albedo_map", map_chosen(options)},
          {"coppermoon:relative_error", static_cast<float>(error)},
          {"coppermoon:recipe", recipe}};
}

/// What the rows of a texture are made from, for as long as any may be asked for.
struct LitGround {
  std::shared_ptr<const algebra::Grid<float>> albedo;
  shadow::Lookup light;
  ProgressBar bar{"bake"};
};

}  // namespace

void add_moon_options(CLI::App& verb, MoonOptions& options) {
  verb.add_option("instant,--instant", options.instant,
                  "ISO 8601 UTC, as 2008-02-21T03:08:26Z; or an .exr that coppermoon made, to make "
                  "it again")
      ->required();
  add_film_moon_options(verb, options);
}

void add_film_moon_options(CLI::App& verb, MoonOptions& options) {
  verb.add_option("--albedo-map", options.albedo_map,
                  "any image 2:1, longitude 0 in the middle; auto; built-in");
  verb.add_option("--photometry", options.photometry,
                  "lommel-seeliger-rolo: as telescopes measured, with the opposition surge; "
                  "yapo-cutler: the paper's, the same at every phase")
      ->check(CLI::IsMember({"lommel-seeliger-rolo", "yapo-cutler"}));
  verb.add_option(
      "--albedo-exponent", options.albedo_exponent,
      "power of the map's values, which undoes a tone curve, 0.1 to 10; without: 0.5 for "
      "Stellarium's map, 1 for any other");
  verb.add_option("--texture-width", options.texture_width,
                  "in texels, even, 4 to 32768; without: 4096, for a frame what it can show")
      ->check(CLI::NonNegativeNumber);
  verb.add_flag("--unshadowed", options.unshadowed, "light the Moon as if the Earth were away");
  add_light_options(verb, options.light);
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
  auto albedo = [&] {
    const Silence silence;
    return texture::read_albedo_map(map, texture::Coding::as_file_says, exponent);
  }();
  return surface::normalised_to_geometric_albedo(std::move(albedo), photometry_of(options));
}

double BakedMoon::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

BakedMoon baked_moon(const MoonOptions& options, const almanac::SkyState& sky,
                     colour::WorkingSpace space,
                     const std::optional<atmosphere::Sightline>& sightline,
                     const std::string& recipe, texture::Extent extent) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t width = texture_width_of(options);
  const Purpose purpose{static_cast<double>(width * (width / 2)), reads_map(options)};
  std::shared_ptr<const algebra::Grid<float>> albedo;
  Moonlight light;
  tbb::task_group together;  // the map and the light have nothing in common
  together.run(
      [&] { albedo = std::make_shared<const algebra::Grid<float>>(normal_albedo(options)); });
  together.run_and_wait(
      [&] { light = light_on_the_moon(options.light, sky, options.unshadowed, purpose); });
  const auto made = options.unshadowed ? recipe : with_work(recipe, light.plan.work);
  auto moon =
      lit_moon(options, sky, space, sightline, albedo, light, light.range, made, extent, true);
  moon.start = start;
  return moon;
}

BakedMoon lit_moon(const MoonOptions& options, const almanac::SkyState& sky,
                   colour::WorkingSpace space,
                   const std::optional<atmosphere::Sightline>& sightline,
                   std::shared_ptr<const algebra::Grid<float>> albedo, const Moonlight& light,
                   const std::optional<shadow::LookupRange>& within, const std::string& recipe,
                   texture::Extent extent, bool bar) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t width = texture_width_of(options), rows = width / 2;
  const auto weights =
      moonlight_weights(colour::channel_weights(space, band_edges_nm()), sightline);
  const std::shared_ptr<LitGround> ground(new LitGround{
      std::move(albedo), within ? light.in_channels(weights, *within) : shadow::Lookup(weights)});
  ground->light.transform([&](std::span<double> colour) { into_gamut_or_black(space, colour); });
  auto lit = texture::lit_rows(*ground->albedo, sky, ground->light, rows, photometry_of(options),
                               extent, bar ? ground->bar.progress() : algebra::Progress());
  return {{width, rows, channel_names(space)},
          [ground, lit](std::size_t first_row, std::span<float> values) { lit(first_row, values); },
          header(options, sky, space, recipe, light.error_found),
          recipe,
          light.plan,
          light.error_found,
          start};
}

void require_place_for(const std::filesystem::path& file) {
  const auto folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::is_directory(folder))
    throw algebra::Error(fmt::format("{}: no such directory", folder.string()));
  if (std::filesystem::is_directory(file))
    throw algebra::Error(fmt::format("{}: is a directory", file.string()));
}

}  // namespace coppermoon::verbs
