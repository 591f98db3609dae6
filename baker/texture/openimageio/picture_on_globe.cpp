// SPDX-License-Identifier: MIT
#include "texture/openimageio/picture_on_globe.h"

#include <algorithm>

#include "algebra/error.h"
#include "texture/openimageio/oiio.h"
#include "texture/write_glb.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;
namespace fs = std::filesystem;

void require_picture(const fs::path& path, const Image& image) {
  const auto fail = [&](const std::string& what) { throw Error(path.string() + ": " + what); };
  const auto channels = image.channels.size();
  if (channels != 1 && channels != 3)
    fail(fmt::format("picture of {} channels, allowed 1 or 3", channels));
  if (image.width < 2 || image.width > most_glb_columns)
    fail(fmt::format("picture {} texels wide, allowed 2 to {}, which viewers can show", image.width,
                     most_glb_columns));
  if (2 * image.height + 1 < image.width || 2 * image.height > image.width + 1)
    fail(fmt::format("picture of {} x {} texels, allowed 2:1", image.width, image.height));
  if (image.values.size() != image.width * image.height * channels)
    fail(
        fmt::format("picture of {} values, allowed as many as its size says", image.values.size()));
  const auto wrong =
      std::ranges::find_if(image.values, [](float v) { return !(v >= 0 && v <= 1); });
  if (wrong != image.values.end()) fail(fmt::format("texel = {}, allowed 0 to 1", *wrong));
}

}  // namespace

std::string picture_on_globe(const fs::path& path, const Image& image, int bits) {
  require_picture(path, image);
  OIIO::Filesystem::IOVecOutput bytes;
  OIIO::Filesystem::IOProxy* proxy = &bytes;
  OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height),
                       static_cast<int>(image.channels.size()),
                       bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16);
  spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, static_cast<void*>(&proxy));
  const auto output = OIIO::ImageOutput::create("png");
  const bool written = output && output->open("", spec) &&
                       output->write_image(OIIO::TypeDesc::FLOAT, image.values.data()) &&
                       output->close();
  const auto reason = (output ? output->geterror() : "") + OIIO::geterror();
  if (!written) throw Error(fmt::format("{}: cannot be written as PNG: {}", path.string(), reason));
  return {bytes.buffer().begin(), bytes.buffer().end()};
}

}  // namespace coppermoon::texture
