// SPDX-License-Identifier: MIT
#include "uses/film/film_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "algebra/error.h"
#include "atmosphere/astronomical_refraction.h"
#include "files/fingerprint.h"
#include "files/own_file.h"
#include "files/temporary_folder.h"
#include "files/whole_file.h"
#include "povray_scenes/moon_include.h"
#include "povray_scenes/render.h"
#include "texture/read_image.h"
#include "uses/dome/dome.h"

namespace coppermoon::uses {
namespace {

namespace fs = std::filesystem;

constexpr const char* stars_name = "eclipse_stars.inc";

/// Adds the bytes of a file, and of the files that it names in quotes, to `all`. Each file is added once. Files that
/// are written anew for each frame are left out.
void add_contents(const fs::path& file, std::set<fs::path>& seen, std::string& all) {
  static const std::set<fs::path> ours{"moon.inc", "coppermoon.inc", stars_name};
  std::error_code none;
  if (ours.contains(file.filename()) || !fs::is_regular_file(file, none) ||
      !seen.insert(file).second)
    return;
  const auto bytes = files::bytes_of(file);
  all += fmt::format("{}\n{}", bytes.size(), bytes);
  if (file.extension() != ".inc" && file.extension() != ".pov") return;
  std::istringstream words(bytes);
  for (std::string word; std::getline(words, word, '"');)
    if (!word.empty()) add_contents((file.parent_path() / word).lexically_normal(), seen, all);
}

}  // namespace

void require_scene(const Film& film) {
  const auto require = [&](bool sound, const char* why) {
    if (!sound) throw algebra::Error(fmt::format("{}: {}", film.scene.string(), why));
  };
  require(film.scene.extension() == ".pov", "a scene of POV-Ray ends in .pov");
  require(fs::is_regular_file(film.scene), "not found");
  require(film.view.observer.has_value(), "has a sky, allowed with a place of the observer");
  require(!film.products.textures, "shows frames and pictures, allowed without textures");
}

View scene_view(const Film& film, const almanac::SkyState& sky) {
  auto view = view_of({.width = film.view.width, .height = film.view.height}, sky);
  const auto& observer = *film.view.observer;
  view.observer = observer;
  view.stars = film.view.stars;
  view.refracted = film.view.flattening;
  if (film.view.reddening)
    view.sightline = {
        air_over(observer, film.view),
        std::max(almanac::view_from(observer, sky).altitude, atmosphere::lowest_true_altitude)};
  return view;
}

std::string scene_contents(const fs::path& scene) {
  if (scene.empty()) return {};
  std::set<fs::path> seen;
  std::string all;
  add_contents(fs::absolute(scene), seen, all);
  return fmt::format(" scene {:016x}", files::fingerprint(all));
}

texture::Image rendered_scene(const Film& film, std::size_t frame, const LitScene& scene,
                              int threads) {
  const files::TemporaryFolder folder;
  const auto beside = [&](const std::string& name) { return folder.path() / name; };
  texture::write_exr(beside(texture_stem + std::string(".exr")), scene.texture.parts,
                     scene.texture.attributes, {.packed = false});
  write_moon_include(folder.path(), scene, film.view);
  if (!fs::exists(beside(stars_name)))  // so that scenes can include the file even without stars
    files::write_whole(beside(stars_name), povray_scenes::star_include("no stars", {}));
  write_sky(beside(povray_scenes::sky_file), scene.moon, film.view);
  const auto [width, height] = std::pair(film.view.width, film.view.height);
  const auto first = film.moments.first_frame, last = film.moments.last_frame();
  try {
    return texture::read_image(povray_scenes::render_own(
        folder.path(), {film.scene, width, height, frame, first, last}, {.threads = threads}));
  } catch (const algebra::Error& error) {
    throw algebra::Error(fmt::format("{}: frame {}: {}", film.scene.string(), frame, error.what()));
  }
}

}  // namespace coppermoon::uses
