// SPDX-License-Identifier: MIT
#include "texture/openimageio/image_input.h"

#include <array>
#include <cmath>
#include <system_error>
#include <utility>

#include "files/whole_file.h"
#include "texture/openimageio/fits_input.h"
#include "texture/openimageio/image_claims.h"
#include "texture/openimageio/raw_input.h"

namespace coppermoon::texture {

namespace fs = std::filesystem;
using algebra::Error;

Error cannot_read(const fs::path& path, std::string_view reason) {
  return Error(fmt::format("{}: cannot be read: {}", path.string(), reason));
}

/// The first line of OpenImageIO's error message. The message must always be fetched, or OpenImageIO prints it at exit.
std::string reason_of(OIIO::ImageInput* input) {
  auto text = input ? input->geterror() : std::string();
  const auto pending = OIIO::geterror();
  if (text.empty()) text = pending;
  text = text.substr(0, text.find('\n'));
  return text.empty() ? "no image, or one of an unknown kind" : text;
}

namespace {

/// Refuses an image larger than its file can hold, before memory is allocated, because a header may claim any size.
void require_size(const fs::path& path, const OIIO::ImageInput& input) {
  const auto& spec = input.spec();
  const auto [data, display] = windows_of(input);
  for (const auto& [left, top, width, height] : {data, display}) {
    require_within(path, "width [texels]", static_cast<double>(width), most_texels_a_side);
    require_within(path, "height [texels]", static_cast<double>(height), most_texels_a_side);
    require_within(path, "distance from the origin [texels]",
                   std::max(std::abs(left * 1.), std::abs(top * 1.)), most_texels_a_side);
    require_numbers(path,
                    static_cast<double>(width) * static_cast<double>(height) * spec.nchannels);
  }
  const double tile = 1. * spec.tile_width * spec.tile_height * spec.nchannels;
  require_within(path, "numbers of a tile in a file so small", tile, most_numbers_in(path));
}

/// Bytes by which a file format is recognised, and their offset in the file.
struct Sign {
  std::size_t at;
  std::string_view bytes;
  const char* format;
};

/// OpenImageIO's name for the format of a file, found from its first bytes or else from its extension. Without a
/// format, OpenImageIO would try all its readers if one refuses the file, even those for films and medical images. Most
/// cameras' raw files begin like a TIFF, so these two are told apart by the extension.
std::string format_of(const fs::path& path) {
  using namespace std::string_view_literals;
  constexpr std::array<Sign, 19> known{{{0, "v/1\x01"sv, "openexr"},
                                        {0, "II*\0"sv, "tiff"},
                                        {0, "MM\0*"sv, "tiff"},
                                        {0, "II+\0"sv, "tiff"},
                                        {0, "MM\0+"sv, "tiff"},
                                        {0, "\x89PNG"sv, "png"},
                                        {0, "\xFF\xD8"sv, "jpeg"},
                                        {0, "SIMPLE  ="sv, "fits"},
                                        {0, "GIF8"sv, "gif"},
                                        {0, "BM"sv, "bmp"},
                                        {0, "8BPS"sv, "psd"},
                                        {0, "#?RADIANCE"sv, "hdr"},
                                        {0, "#?RGBE"sv, "hdr"},
                                        {0, "\0\0\0\x0CjP  "sv, "jpeg2000"},
                                        {4, "ftypheic"sv, "heif"},
                                        {4, "ftypheix"sv, "heif"},
                                        {4, "ftypmif1"sv, "heif"},
                                        {4, "ftypavif"sv, "heif"},
                                        {8, "WEBPVP8"sv, "webp"}}};
  constexpr std::size_t longest = 16;
  auto bytes = files::beginning_of(path, longest);
  if (bytes.empty()) throw cannot_read(path, "it is empty");
  bytes.resize(longest);
  const std::string_view beginning(bytes);
  for (const auto& [at, sign, format] : known)
    if (beginning.substr(at).starts_with(sign))
      return std::string_view(format) == "tiff" && has_raw_ending(path) ? "raw" : format;
  const auto ending = path.extension().string();
  const auto kind = ending.empty() ? ending : ending.substr(1);
  const bool fits = OIIO::Strutil::iequals(kind, "fit") || OIIO::Strutil::iequals(kind, "fts");
  return fits ? "fits" : kind;
}

}  // namespace

bool has_openexr(const fs::path& path) {
  std::error_code failed;
  return fs::is_regular_file(path, failed) && format_of(path) == "openexr";
}

std::unique_ptr<OIIO::ImageInput> opened(const fs::path& path) {
  const auto format = format_of(path);
  require_honest_claims(path, format);
  auto input = format.empty()     ? nullptr
               : format == "fits" ? fits_input()
                                  : OIIO::ImageInput::create(format);
  OIIO::ImageSpec spec;
  if (!input || !input->open(path.string(), spec, raw_hints()))
    throw cannot_read(
        path, reason_of(input.get()) +
                  (format == "raw" ? "; it begins as a TIFF does, whose name ends in .tif" : ""));
  if (spec.deep || spec.depth > 1 || spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
    throw cannot_read(path, "not a flat image with texels");
  if (is_openexr(*input) && (spec.full_width < 1 || spec.full_height < 1))
    throw cannot_read(path, "a display window without texels");
  require_size(path, *input);
  return input;
}

bool is_openexr(const OIIO::ImageInput& input) {
  return std::string_view(input.format_name()) == "openexr";
}

Windows windows_of(const OIIO::ImageInput& input) {
  const auto& spec = input.spec();
  const auto window = [](int left, int top, int width, int height) {
    return ImageWindow{left, top, static_cast<std::size_t>(width),
                       static_cast<std::size_t>(height)};
  };
  const auto data = window(spec.x, spec.y, spec.width, spec.height);
  if (!is_openexr(input)) return {data, data};
  return {data, window(spec.full_x, spec.full_y, spec.full_width, spec.full_height)};
}

}  // namespace coppermoon::texture
