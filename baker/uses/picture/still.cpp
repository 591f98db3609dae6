// SPDX-License-Identifier: MIT
#include "uses/picture/still.h"

#include <tbb/task_group.h>

#include <algorithm>
#include <vector>

#include "files/temporary_folder.h"
#include "povray_scenes/render.h"
#include "texture/read_image.h"
#include "uses/light/header.h"
#include "uses/picture/disc_outline.h"
#include "uses/picture/pixels.h"
#include "uses/picture/sky_lights.h"

namespace coppermoon::uses {

texture::Image rendered(const LitScene& scene, const algebra::Progress& progress) {
  const files::TemporaryFolder folder;
  std::vector<SkyLight> lights;
  tbb::task_group beside;  // POV-Ray sleeps when it starts
  beside.run([&] { lights = sky_lights(scene.view, scene.moon.sky); });
  write_lit_scene(folder.path(), scene, {}, {.packed = false});
  const auto window = disc_window({&scene.view.camera, 1});
  texture::Image frame;
  povray_scenes::render_for([&](const auto& exr) { frame = texture::read_image(exr); },
                            folder.path(), {.window = window}, progress);
  beside.wait();
  add_lights(frame, scene.view.camera, lights);
  hide_below_horizon(frame, scene.view, scene.moon.sky);
  return frame;
}

texture::Attributes frame_header(const LitScene& scene, const Exposures& exposures) {
  auto attributes = scene.texture.attributes;
  add_exposure(attributes, exposures);
  add_seen(attributes, seen_by(scene.view, scene.moon.sky));
  return attributes;
}

texture::ExrType frame_type(const texture::Image& frame) {
  constexpr float most_of_half = 65504;
  const bool beyond = std::ranges::any_of(frame.values, [](float v) { return v > most_of_half; });
  return beyond ? texture::ExrType::floating : texture::ExrType::half;
}

void write_frame(const std::filesystem::path& file, const texture::Image& frame,
                 texture::Attributes header, colour::WorkingSpace space) {
  if (space == picture_space)
    return texture::write_exr(file, frame, header, {.type = frame_type(frame)});
  say_space(header, space);
  const auto changed = in_space(frame, picture_space, space);
  texture::write_exr(file, changed, header, {.type = frame_type(changed)});
}

}  // namespace coppermoon::uses
