// SPDX-License-Identifier: MIT
#include "uses/picture/lit_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "files/lock.h"
#include "files/own_file.h"
#include "files/whole_file.h"
#include "povray_scenes/mitsuba.h"
#include "povray_scenes/moon_include.h"
#include "texture/images_ahead.h"
#include "texture/own_image.h"
#include "uses/light/photometer.h"
#include "uses/picture/brightness.h"
#include "uses/picture/clear_sky.h"
#include "uses/picture/sky_lights.h"

namespace coppermoon::uses {
namespace {

constexpr const char *texture_file = "moon_lin_rec709.exr", *moon_file = "moon.inc",
                     *stars_file = "eclipse_stars.inc", *macros_file = "coppermoon.inc",
                     *air_file = "eclipse_air.exr";

/// Diameter of the Moon's disc [pixels].
double diameter(const povray_scenes::SceneCamera& camera) {
  const double away = glm::length(camera.position);  // distance in lunar radii
  const double tangent = 1 / std::sqrt(away * away - 1);
  return static_cast<double>(camera.width) * tangent /
         std::tan(algebra::in_radians(camera.horizontal_field) / 2);
}

}  // namespace

FrameView view_for_frame(const ViewRequest& request, const almanac::SkyState& sky) {
  constexpr double visible_px = 0.25;
  FrameView frame{view_of(request, sky), {}};
  auto& camera = frame.view.camera;
  const double flattened_px = (1 - camera.flattening) * diameter(camera);
  if (camera.flattening < 1 && flattened_px < visible_px) {
    frame.left_out.push_back(fmt::format("flattening of the disc: {:.2g} pixel", flattened_px));
    camera.flattening = 1;
  }
  if (!frame.view.sightline) frame.left_out.push_back("air above the observer, who is in space");
  return frame;
}

MoonRequest fitted(MoonRequest moon, const povray_scenes::SceneCamera& camera) {
  if (moon.texture_width) return moon;
  const double width = moon.texels_per_pixel * std::numbers::pi * diameter(camera);
  moon.texture_width =
      static_cast<std::size_t>(std::ceil(std::clamp(width, 64., 16384.) / 32)) * 32;
  return moon;
}

LitScene lit_scene(const MoonRequest& request, const ViewRequest& view,
                   const almanac::SkyState& sky, const SceneBaking& baking) {
  const texture::ImagesAhead images;
  auto seen = view_for_frame(view, sky).view;
  seen.response = request.response.value_or("");
  auto moon = lit_moon(fitted(request, seen.camera), sky, baking.light);
  moon.observer = seen.observer;
  moon.sightline = seen.sightline;
  auto texture = baked(moon, {}, baking.texture);
  FrameSky air(seen, moon);
  return {std::move(moon), seen, std::move(texture), std::move(air)};
}

void require_scene_folder(const std::filesystem::path& folder, const ViewRequest& view,
                          Renderer renderer) {
  texture::require_own_image(folder / texture_file);
  if (view.observer) texture::require_own_image(folder / povray_scenes::sky_file);
  if (renderer == Renderer::mitsuba) return povray_scenes::require_mitsuba_place(folder);
  texture::require_own_image(folder / air_file);
  povray_scenes::require_scene_place(folder);
  if (!view.observer) return;
  for (const char* file : {moon_file, stars_file}) files::require_stamped(folder / file);
  const auto copied = folder / macros_file;  // the user may have put a copy here
  files::require_no_link(copied);
  if (std::filesystem::exists(copied) && files::bytes_of(copied) != povray_scenes::coppermoon_inc())
    files::require_stamped(copied);
}

void write_moon_include(const std::filesystem::path& folder, const LitScene& scene,
                        const ViewRequest& request) {
  if (!scene.view.observer) return;
  const auto& sky = scene.moon.sky;
  const auto view = almanac::view_from(*scene.view.observer, sky);
  const bool up = moon_is_up(request, sky);
  const ClearSky over(*scene.view.observer, sky, air_over(*scene.view.observer, request),
                      magnitudes_above(scene.moon)[V_band]);
  const povray_scenes::MoonInSky moon{
      .texture = texture_file,
      .title = almanac::utc_text(sky.when) + " from " + place_text(*scene.view.observer),
      .view = view,
      .axis_position_angle = sky.axis_position_angle,
      .place = apparent_place(*scene.view.observer, sky),
      .sun_altitude = over.sun_altitude(),
      .sky_cd_m2 = over.zenith_cd_m2(),
      .illuminance_lux = up ? illuminance_seen(scene.moon) : std::array{0., 0., 0.},
      .up = up};
  const auto write = [&](const char* file, std::string_view text) {
    files::write_whole(folder / file, files::stamped(text, "//"));
  };
  write(moon_file, povray_scenes::moon_include(moon));
  if (const auto stars = lights_over(scene.view, sky); !stars.empty())
    write(stars_file, povray_scenes::star_include(moon.title, stars));
  write(macros_file, povray_scenes::coppermoon_inc());
}

void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const std::vector<povray_scenes::SkyLight>& lights, Renderer renderer) {
  povray_scenes::MoonScene moon{
      .camera = scene.view.camera, .texture = texture_file, .lights = lights};
  std::error_code ignored;
  const bool made = std::filesystem::create_directory(folder, ignored);
  const auto alone = files::lock_folder(folder);
  try {
    texture::write_exr(folder / texture_file, scene.texture.parts, scene.texture.attributes);
    if (renderer == Renderer::mitsuba) return write_mitsuba_scene(folder, moon);
    if (!scene.sky.black()) {
      const auto [step, light] = scene.sky.nodes();
      moon.air = {air_file, light.width, light.height, step};
      texture::write_exr(folder / air_file, light, scene.texture.attributes);
    }
    write_scene(folder, moon);
  } catch (...) {
    if (made) std::filesystem::remove_all(folder, ignored);
    throw;
  }
}

texture::UsdMoment usd_moment(const LitMoon& moon, const View& view, colour::WorkingSpace space) {
  const auto direction = line_of_sight(view.camera);
  const auto up = view.camera.up - glm::dot(view.camera.up, direction) * direction;
  return {.position = view.camera.position,
          .direction = direction,
          .up = glm::normalize(up),
          .field_rad = algebra::in_radians(view.camera.horizontal_field),
          .lux = illuminance_seen(moon, space)};
}

std::array<double, 3> luminance_of_channels(colour::WorkingSpace space) {
  const auto of = [&](std::array<double, 3> colour) { return colour::luminance(space, colour); };
  return {of({1, 0, 0}), of({0, 1, 0}), of({0, 0, 1})};
}

}  // namespace coppermoon::uses
