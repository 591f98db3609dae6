// SPDX-License-Identifier: MIT
#include "texture/openimageio/image_functions.h"

namespace texture = coppermoon::texture;

extern "C" __attribute__((visibility("default"))) const texture::ImageFunctions*
coppermoon_image_functions() {
  static constexpr texture::ImageFunctions functions{
      .version = COPPERMOON_VERSION,
      .read_image = texture::read_image,
      .read_channels = texture::read_channels,
      .windows_of = texture::windows_of,
      .read_attributes = texture::read_attributes,
      .read_light = texture::read_light,
      .is_raw_file = texture::is_raw_file,
      .read_albedo_map = texture::read_albedo_map,
      .require_albedo_map = texture::require_albedo_map,
      .write_exr = texture::write_exr,
      .write_exr_of_parts = texture::write_exr,
      .write_mipmapped = texture::write_mipmapped,
      .write_picture = texture::write_picture,
      .write_png = texture::write_png,
      .write_tiff = texture::write_tiff,
      .write_dng = texture::write_dng,
      .write_glb = texture::write_glb,
      .write_usdz = texture::write_usdz,
      .sheet_font = texture::sheet_font,
      .drawn = texture::drawn,
      .write_captions = texture::write_captions};
  return &functions;
}
