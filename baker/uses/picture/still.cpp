// SPDX-License-Identifier: MIT
#include "uses/picture/still.h"

#include "files/temporary_folder.h"
#include "povray_scenes/render.h"
#include "texture/read_image.h"

namespace coppermoon::uses {

texture::Image rendered(const LitScene& scene, const algebra::Progress& progress) {
  const files::TemporaryFolder folder;
  write_lit_scene(folder.path(), scene, {.packed = false});
  return texture::read_image(povray_scenes::render(folder.path(), {}, progress));
}

texture::Attributes frame_header(const LitScene& scene, const colour::Exposure& exposure) {
  auto attributes = scene.texture.attributes;
  add_exposure(attributes, exposure);
  add_seen(attributes, seen_by(scene.view, scene.moon.sky));
  return attributes;
}

}  // namespace coppermoon::uses
