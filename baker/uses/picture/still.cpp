// SPDX-License-Identifier: MIT
#include "uses/picture/still.h"

#include "files/temporary_folder.h"
#include "povray_scenes/render.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/light/header.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {

texture::Image rendered(const LitScene& scene, const algebra::Progress& progress) {
  const files::TemporaryFolder folder;
  write_lit_scene(folder.path(), scene, {.packed = false});
  return texture::read_image(povray_scenes::render(folder.path(), {}, progress));
}

texture::Attributes frame_header(const LitScene& scene, const Exposures& exposures) {
  auto attributes = scene.texture.attributes;
  add_exposure(attributes, exposures);
  add_seen(attributes, seen_by(scene.view, scene.moon.sky));
  return attributes;
}

void write_frame(const std::filesystem::path& file, const texture::Image& frame,
                 texture::Attributes header, colour::WorkingSpace space) {
  if (space == picture_space) return texture::write_exr(file, frame, header);
  say_space(header, space);
  texture::write_exr(file, in_space(frame, picture_space, space), header);
}

}  // namespace coppermoon::uses
