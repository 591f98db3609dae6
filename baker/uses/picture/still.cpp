// SPDX-License-Identifier: MIT
#include "uses/picture/still.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/temporary_folder.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/render.h"
#include "povray_scenes/scene_camera.h"
#include "texture/read_image.h"
#include "uses/light/header.h"
#include "uses/picture/disc_outline.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

using texture::ExrType, texture::Image;

constexpr std::size_t colours = 3;

/// The type in which a frame's numbers are stored.
ExrType type_of(const Image& frame) {
  constexpr float most_of_half = 65504;
  const bool beyond = std::ranges::any_of(frame.values, [](float v) { return v > most_of_half; });
  return beyond ? ExrType::floating : ExrType::half;
}

Image with_alpha(const Image& colour, const Image& moon) {
  auto channels = colour.channels;
  channels.emplace_back("A");
  Image image(colour.width, colour.height, channels);
  for (std::size_t i = 0; i < colour.width * colour.height; ++i) {
    std::copy_n(&colour.values[colours * i], colours, &image.values[(colours + 1) * i]);
    image.values[(colours + 1) * i + colours] = moon.values[(colours + 1) * i + colours];
  }
  return image;
}

/// Sets alpha to 0 outside the window that was rendered, because POV-Ray writes 1 there.
void clear_beside(Image& moon, const std::optional<povray_scenes::RenderWindow>& window) {
  for (std::size_t r = 0; window && r < moon.height; ++r)
    for (std::size_t c = 0; c < moon.width; ++c)
      if (r < window->top || r >= window->bottom || c < window->left || c >= window->right)
        moon(r, c, colours) = 0;
}

/// The light of the stars: the frame minus the Moon, both rounded as they are stored.
Image stars_of(const LinearFrame& frame, ExrType type) {
  auto stars = frame.light;
  for (std::size_t i = 0; i < stars.values.size(); ++i) {
    const float moon = frame.moon.values[i / colours * (colours + 1) + i % colours];
    float& value = stars.values[i];
    value = (type == ExrType::half ? as_half(value) : value) - as_half(moon);
  }
  return stars;
}

/// The frame as the sum of its stored parts: Moon, sky and stars.
Image sum_of(const LinearFrame& frame, const Image& stars) {
  auto sum = stars;
  for (std::size_t i = 0; i < sum.values.size(); ++i)
    sum.values[i] +=
        as_half(frame.moon.values[i / colours * (colours + 1) + i % colours]) + frame.sky.values[i];
  return sum;
}

Image positions(const Image& moon, const povray_scenes::SceneCamera& camera) {
  const auto sight = povray_scenes::sight_of(camera);
  Image image(moon.width, moon.height, {"X", "Y", "Z"});
  for (std::size_t r = 0; r < moon.height; ++r)
    for (std::size_t c = 0; c < moon.width; ++c)
      if (moon(r, c, colours) > 0)
        if (const auto place =
                ground_at(sight, {static_cast<double>(c) + 0.5, static_cast<double>(r) + 0.5}))
          for (std::size_t k = 0; k < colours; ++k)
            image(r, c, k) = static_cast<float>((*place)[static_cast<int>(k)]);
  return image;
}

/// Part of a frame's file. The image must outlive the part. Blender tells parts apart only by the names of their
/// channels, such as moon.R.
texture::Part part_of(const std::string& name, const Image& image,
                      const texture::ExrOptions& options) {
  texture::Layout layout{image.width, image.height, image.channels};
  if (name != "rgba")
    for (auto& channel : layout.channels) channel = name + "." + channel;
  return {.name = name,
          .layout = layout,
          .rows = texture::rows_of(image),
          .left_out = {},
          .own = {},
          .options = options};
}

}  // namespace

Image LinearFrame::whole() const {
  auto sum = light;
  for (std::size_t i = 0; i < sky.values.size(); ++i)
    sum.values[i] = as_half(sum.values[i] + sky.values[i]);
  return sum;
}

LinearFrame completed(Image rendered, const View& view, const almanac::SkyState& sky,
                      std::span<const SkyLight> lights, const FrameSky& air) {
  LinearFrame frame{std::move(rendered)};
  const bool passes = frame.light.channels.size() > colours;
  if (passes) {
    frame.moon = std::move(frame.light);
    frame.light = image_of(pixels_of(frame.moon));
    clear_beside(frame.moon, disc_window({&view.camera, 1}));
    hide_below_horizon(frame.moon, view, sky);
    if (!air.black()) {
      frame.sky = {frame.light.width, frame.light.height, frame.light.channels};
      air.add_to(frame.sky);
      hide_below_horizon(frame.sky, view, sky);
    }
  }
  add_lights(frame.light, view.camera, lights);
  if (!passes) air.add_to(frame.light);
  hide_below_horizon(frame.light, view, sky);
  if (!passes && !air.black())
    for (float& value : frame.light.values) value = as_half(value);
  return frame;
}

LinearFrame rendered(const LitScene& scene, bool passes, const algebra::Progress& progress) {
  const files::TemporaryFolder folder;
  std::vector<SkyLight> lights;
  tbb::task_group beside;  // finds the stars while POV-Ray's start leaves the CPU idle
  beside.run([&] { lights = sky_lights(scene.view, scene.moon.sky); });
  constexpr const char* texture_file = "moon_lin_rec709.exr";
  texture::write_exr(folder.path() / texture_file, scene.texture.parts, scene.texture.attributes,
                     {.packed = false});
  povray_scenes::write_scene(
      folder.path(), {.camera = scene.view.camera, .texture = texture_file, .alpha = passes});
  const auto window = disc_window({&scene.view.camera, 1});
  Image frame;
  povray_scenes::render_for([&](const auto& exr) { frame = texture::read_image(exr); },
                            folder.path(), {.window = window}, progress);
  beside.wait();
  return completed(std::move(frame), scene.view, scene.moon.sky, lights, scene.sky);
}

double frame_memory(std::size_t width, std::size_t height, bool through_camera) {
  const double a_pixel = through_camera ? 75 + 128 : 75;
  return a_pixel * static_cast<double>(width) * static_cast<double>(height);
}

LinearFrame in_space(const LinearFrame& frame, colour::WorkingSpace from, colour::WorkingSpace to) {
  if (from == to) return frame;
  LinearFrame changed{in_space(frame.light, from, to)};
  if (!frame.sky.values.empty()) changed.sky = in_space(frame.sky, from, to);
  if (!frame.moon.values.empty())
    changed.moon = with_alpha(in_space(frame.moon, from, to), frame.moon);
  return changed;
}

texture::Attributes frame_header(const LitScene& scene, const Exposures& exposures) {
  auto attributes = scene.texture.attributes;
  add_exposure(attributes, exposures);
  add_seen(attributes, seen_by(scene.view, scene.sky));
  return attributes;
}

void write_frame(const std::filesystem::path& file, const LinearFrame& frame,
                 const povray_scenes::SceneCamera& camera, const texture::Attributes& header) {
  const texture::ExrOptions light{.type = type_of(frame.light)}, floats{.type = ExrType::floating};
  if (frame.moon.values.empty()) return texture::write_exr(file, frame.light, header, light);
  const bool black = frame.sky.values.empty();
  const auto stars = stars_of(frame, light.type),
             all = with_alpha(black ? frame.light : sum_of(frame, stars), frame.moon),
             places = positions(frame.moon, camera);
  std::vector<texture::Part> parts{part_of("rgba", all, black ? light : floats),
                                   part_of("moon", frame.moon, {})};
  if (!black) parts.push_back(part_of("sky", frame.sky, floats));
  parts.push_back(part_of("stars", stars, floats));
  parts.push_back(part_of("position", places, {.type = ExrType::floating, .allow_negative = true}));
  parts.back().left_out = {"whiteLuminance", "chromaticities"};
  parts.back().own = {{"colorInteropID", std::string("data")},
                      {"coppermoon:unit", std::string("lunar radii")}};
  texture::write_exr(file, parts, header);
}

}  // namespace coppermoon::uses
