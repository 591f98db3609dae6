// SPDX-License-Identifier: MIT
#include "verbs/lit_scene.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "almanac/instant.h"
#include "povray_scenes/scene.h"
#include "verbs/recipe.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* texture_file = "moon_lin_rec709.exr";

/// Of the disc, in pixels.
double diameter(const povray_scenes::Camera& camera) {
  const double away = glm::length(camera.position);  // in lunar radii
  const double tangent = 1 / std::sqrt(away * away - 1);
  return static_cast<double>(camera.width) * tangent /
         std::tan(algebra::in_radians(camera.horizontal_field) / 2);
}

}  // namespace

FrameView view_for_frame(const ViewOptions& options, const almanac::SkyState& sky) {
  constexpr double visible_px = 0.25;
  FrameView frame{view_of(options, sky), {}};
  auto& camera = frame.view.camera;
  const double flattened_px = (1 - camera.flattening) * diameter(camera);
  if (camera.flattening < 1 && flattened_px < visible_px) {
    frame.left_out.push_back(fmt::format("flattening of the disc: {:.2g} pixel", flattened_px));
    camera.flattening = 1;
  }
  if (!frame.view.sightline) frame.left_out.push_back("air above the observer, who is in space");
  return frame;
}

MoonOptions fitted(MoonOptions moon, const povray_scenes::Camera& camera) {
  if (moon.texture_width) return moon;
  const double share = moon.light.plan.quality == "draft" ? 0.5 : 1;
  const double width = share * std::numbers::pi * diameter(camera);
  moon.texture_width =
      static_cast<std::size_t>(std::ceil(std::clamp(width, 64., 16384.) / 32)) * 32;
  return moon;
}

LitScene lit_scene(const MoonOptions& options, const ViewOptions& view, const std::string& recipe,
                   texture::Extent extent) {
  const auto sky = almanac::sky_at(almanac::instant_from_utc(options.instant));
  const auto seen = view_for_frame(view, sky).view;
  const auto moon = fitted(options, seen.camera);
  auto lit = lit_moon(moon, sky, with_width(recipe, *moon.texture_width));
  lit.observer = seen.observer;
  lit.sightline = seen.sightline;
  auto texture = baked(lit, {}, {extent});
  return {std::move(lit), seen, std::move(texture)};
}

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ >= 0) ::flock(descriptor_, LOCK_EX);
}

FolderLock::~FolderLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const texture::ExrOptions& options) {
  povray_scenes::Scene pov{.camera = scene.view.camera, .texture = texture_file, .caption = {}};
  std::error_code ignored;
  const bool made = std::filesystem::create_directory(folder, ignored);
  const FolderLock alone(folder);
  try {
    texture::write_exr(folder / texture_file, scene.texture.parts, scene.texture.attributes,
                       options);
    write_scene(folder, pov);
  } catch (...) {
    if (made) std::filesystem::remove_all(folder, ignored);
    throw;
  }
}

}  // namespace coppermoon::verbs
