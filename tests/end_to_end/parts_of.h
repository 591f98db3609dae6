// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/imageio.h>

#include "support/testing.h"
#include "texture/image.h"

namespace coppermoon::end_to_end {

/// All parts of an OpenEXR file, by name, as OpenImageIO reads them.
inline std::map<std::string, texture::Image> parts_of(const std::filesystem::path& path) {
  std::map<std::string, texture::Image> parts;
  const auto input = OIIO::ImageInput::open(path);
  EXPECT_TRUE(input) << OIIO::geterror();
  for (int i = 0; input && input->seek_subimage(i, 0); ++i) {
    const auto spec = input->spec();
    texture::Image image(static_cast<std::size_t>(spec.width),
                         static_cast<std::size_t>(spec.height), spec.channelnames);
    EXPECT_TRUE(
        input->read_image(i, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data()));
    parts[spec.get_string_attribute("oiio:subimagename")] = std::move(image);
  }
  return parts;
}

}  // namespace coppermoon::end_to_end
