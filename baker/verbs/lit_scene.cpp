// SPDX-License-Identifier: MIT
#include "verbs/lit_scene.h"

#include "almanac/instant.h"
#include "povray_scenes/scene.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* texture_file = "moon_lin_rec709.exr";

void add_observer(texture::Attributes& attributes, const almanac::Observer& observer) {
  attributes["latitude"] = static_cast<float>(algebra::in_degrees(observer.latitude));
  attributes["longitude"] = static_cast<float>(algebra::in_degrees(observer.longitude));
  attributes["altitude"] = static_cast<float>(algebra::in_metres(observer.elevation));
}

}  // namespace

LitScene lit_scene(const MoonOptions& moon, const ViewOptions& view, const std::string& recipe,
                   texture::Extent extent) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(moon.instant));
  const auto seen = view_of(view, sky);
  LitScene scene{
      baked_moon(moon, sky, colour::WorkingSpace::linear_rec709, seen.sightline, recipe, extent),
      seen};
  if (seen.observer) add_observer(scene.moon.attributes, *seen.observer);
  return scene;
}

void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const texture::ExrOptions& options) {
  povray_scenes::Scene pov{.camera = scene.view.camera, .texture = texture_file, .caption = {}};
  std::error_code ignored;
  const bool made = std::filesystem::create_directory(folder, ignored);
  try {
    texture::write_exr(folder / texture_file, scene.moon.layout, scene.moon.rows,
                       scene.moon.attributes, options);
    write_scene(folder, pov);
  } catch (...) {
    if (made) std::filesystem::remove_all(folder, ignored);
    throw;
  }
}

}  // namespace coppermoon::verbs
