// SPDX-License-Identifier: MIT
#include "texture/openimageio/how_stored.h"

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>

#include "algebra/error.h"
#include "algebra/number.h"
#include "files/whole_file.h"
#include "texture/openimageio/image_input.h"

namespace coppermoon::texture {
namespace {

namespace fs = std::filesystem;

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes) value = value << 8 | static_cast<unsigned char>(byte);
  return value;
}

/// The first megabyte of a file, which contains its header.
std::string beginning_of(const fs::path& path) { return files::beginning_of(path, 1 << 20); }

int say_nothing(TIFF*, void*, const char*, const char*, std::va_list) { return 1; }

/// Reads those tags of a TIFF file's first page that OpenImageIO ignores.
class TiffTags {
 public:
  explicit TiffTags(const fs::path& path) {
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(
        TIFFOpenOptionsAlloc(), &TIFFOpenOptionsFree);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), say_nothing, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), say_nothing, nullptr);
    file_.reset(TIFFOpenExt(path.string().c_str(), "rm", options.get()));
  }

  template <class... Values>
  bool get(std::uint32_t tag, Values*... values) const {
    return file_ && TIFFGetField(file_.get(), tag, values...) == 1;
  }

  /// Text of a tag that libtiff does not know.
  std::optional<std::string> text(std::uint32_t tag) const {
    std::uint32_t count = 0;
    const char* found = nullptr;
    if (!get(tag, &count, &found) || !found) return std::nullopt;
    return std::string(found, ::strnlen(found, count));
  }

 private:
  std::unique_ptr<TIFF, void (*)(TIFF*)> file_{nullptr, &TIFFClose};
};

/// Offset that is to be added to a band's numbers according to GDAL's metadata; 0 if the metadata give none.
double gdal_offset(const std::string& metadata) {
  const auto role = metadata.find("role=\"offset\"");
  if (role == metadata.npos) return 0;
  const auto begin = metadata.find('>', role), end = metadata.find('<', role);
  if (begin == metadata.npos || end == metadata.npos || begin > end) return 0;
  return algebra::number_in(metadata.substr(begin + 1, end - begin - 1)).value_or(0);
}

void require_photometric(const fs::path& path, int interpretation) {
  constexpr std::array known{PHOTOMETRIC_MINISWHITE, PHOTOMETRIC_MINISBLACK, PHOTOMETRIC_RGB,
                             PHOTOMETRIC_PALETTE,    PHOTOMETRIC_SEPARATED,  PHOTOMETRIC_YCBCR};
  if (std::find(known.begin(), known.end(), interpretation) != known.end()) return;
  const auto name = interpretation == PHOTOMETRIC_MASK     ? " (a mask)"
                    : interpretation == PHOTOMETRIC_CIELAB ? " (CIE L*a*b*)"
                    : interpretation == PHOTOMETRIC_CFA    ? " (a camera's mosaic)"
                    : interpretation == PHOTOMETRIC_LOGL   ? " (LogL)"
                    : interpretation == PHOTOMETRIC_LOGLUV ? " (LogLuv)"
                    : interpretation == 34892 /* linear */ ? " (a camera's raw colours)"
                                                           : "";
  throw cannot_read(path, fmt::format("PhotometricInterpretation = {}{}, allowed grey, colours of "
                                      "light, palettes, CMYK and YCbCr",
                                      interpretation, name));
}

void require_rec709(const fs::path& path, const TiffTags& tags) {
  const float* xy = nullptr;
  if (!tags.get(TIFFTAG_PRIMARYCHROMATICITIES, &xy) || !xy) return;
  constexpr std::array bt709{0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F};
  for (std::size_t i = 0; i < bt709.size(); ++i)
    if (!(std::abs(xy[i] - bt709[i]) < 0.005F))
      throw cannot_read(path, "PrimaryChromaticities, allowed those of Rec. 709");
}

/// Honours the TIFF tags that OpenImageIO ignores, or refuses the file if one of these tags cannot be honoured.
void heed_tiff(const fs::path& path, const OIIO::ImageSpec& spec, Storage& storage) {
  constexpr std::uint32_t dng_version = 50706, gdal_metadata = 42112, gdal_no_data = 42113;
  const int interpretation = spec.get_int_attribute("tiff:PhotometricInterpretation", 1);
  require_photometric(path, interpretation);
  const TiffTags tags(path);
  const void* dng = nullptr;
  if (beginning_of(path).substr(8, 2) == "CR" || tags.get(dng_version, &dng))
    throw cannot_read(path, "a camera's raw file that does not end as one, as .dng or .cr2");
  if ((spec.get_int_attribute("tiff:subfiletype") & FILETYPE_REDUCEDIMAGE) != 0)
    throw cannot_read(path, "NewSubfileType: its first page is a thumbnail");
  if (interpretation == PHOTOMETRIC_MINISWHITE) {
    const bool sixteen = spec.format == OIIO::TypeDesc::UINT16;
    if (!sixteen && !(spec.format == OIIO::TypeDesc::UINT8 &&
                      spec.get_int_attribute("oiio:BitsPerSample", 8) == 8))
      throw cannot_read(path,
                        "PhotometricInterpretation = 0 (white is zero), allowed of whole "
                        "numbers of 8 and 16 bits");
    storage.white_is_zero = sixteen;  // OpenImageIO itself inverts 8-bit numbers
  }
  const std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
  if (tags.get(TIFFTAG_TRANSFERFUNCTION, &red, &green, &blue))
    throw cannot_read(path, "TransferFunction, allowed are files without");
  if (!spec.find_attribute("ICCProfile")) require_rec709(path, tags);
  if (const double offset = gdal_offset(tags.text(gdal_metadata).value_or("")); offset != 0)
    throw cannot_read(path, fmt::format("GDAL's offset = {:g}, allowed 0", offset));
  if (const auto text = tags.text(gdal_no_data)) storage.no_data = algebra::number_in(*text);
}

std::optional<std::string> icc_of(const OIIO::ImageSpec& spec) {
  const auto* found = spec.find_attribute("ICCProfile");
  if (!found || found->type().basetype != OIIO::TypeDesc::UINT8) return std::nullopt;
  return std::string(static_cast<const char*>(found->data()), found->type().size());
}

void refuse_curve(const fs::path& path, unsigned transfer) {
  if (transfer == 8 || transfer >= 16)
    throw cannot_read(
        path, fmt::format("transfer characteristics = {}{}, allowed those of sRGB", transfer,
                          transfer == 16   ? " (PQ)"
                          : transfer == 18 ? " (HLG)"
                                           : ""));
}

using Colours = std::optional<ColourProfile>;

/// A linear colour space and the identifier that files use for it.
struct NamedSpace {
  std::string_view id;
  std::array<double, 8> xy;  ///< chromaticities x and y of red, green, blue and white
};

constexpr std::array<NamedSpace, 7> named_spaces{
    {{"lin_rec709_scene", {0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329}},
     {"lin_ap0_scene", {0.7347, 0.2653, 0, 1, 0.0001, -0.077, 0.32168, 0.33767}},
     {"lin_ap1_scene", {0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32168, 0.33767}},
     {"lin_p3d65_scene", {0.68, 0.32, 0.265, 0.69, 0.15, 0.06, 0.3127, 0.329}},
     {"lin_rec2020_scene", {0.708, 0.292, 0.17, 0.797, 0.131, 0.046, 0.3127, 0.329}},
     {"lin_adobergb_scene", {0.64, 0.33, 0.21, 0.71, 0.15, 0.06, 0.3127, 0.329}},
     {"lin_ciexyzd65_scene", {1, 0, 0, 1, 0, 0, 1. / 3, 1. / 3}}}};

/// Primaries and white of the linear space with the given identifier; nothing if the identifier is unknown.
std::optional<std::array<double, 8>> primaries_of(std::string_view id) {
  const auto known = std::ranges::find(named_spaces, id, &NamedSpace::id);
  return known != named_spaces.end() ? std::optional(known->xy) : std::nullopt;
}

/// Colour profile for primaries and a transfer function that are given as code points of ITU-T H.273.
Colours by_code_points(const fs::path& path, unsigned primaries, unsigned transfer) {
  refuse_curve(path, transfer);
  const auto xy = primaries_of(primaries == 9    ? "lin_rec2020_scene"
                               : primaries == 12 ? "lin_p3d65_scene"
                                                 : "");
  return xy ? ColourProfile::of_primaries(*xy, {}) : std::nullopt;
}

/// Colour profile of a HEIC or AVIF file. It is in the file's `colr` box, which OpenImageIO ignores.
Colours heif_colours(const fs::path& path, std::size_t channels) {
  const auto bytes = beginning_of(path);
  const std::string_view all(bytes);
  if (const auto at = all.find("colrnclx"); at != all.npos && at + 12 <= all.size())
    return by_code_points(path, big_endian(all.substr(at + 8, 2)),
                          big_endian(all.substr(at + 10, 2)));
  const auto at = std::min(all.find("colrprof"), all.find("colrrICC"));
  if (at == all.npos || at < 4) return std::nullopt;
  const auto size = big_endian(all.substr(at - 4, 4));
  if (size < 12 || at - 4 + size > all.size()) return std::nullopt;
  return ColourProfile::of_icc(all.substr(at + 8, size - 12), channels);
}

/// Contents of the named chunk of a PNG file; nothing if there is no such chunk before the pixels.
std::optional<std::string_view> chunk_of_png(std::string_view all, std::string_view name) {
  for (std::size_t at = 8; at + 8 <= all.size();) {
    const auto size = big_endian(all.substr(at, 4));
    const auto kind = all.substr(at + 4, 4);
    if (kind == "IDAT" || size > all.size() - at - 8) return std::nullopt;
    if (kind == name) return all.substr(at + 8, size);
    at += std::size_t{12} + size;
  }
  return std::nullopt;
}

Colours png_colours(const fs::path& path, const OIIO::ImageSpec& spec) {
  const auto bytes = beginning_of(path);
  if (const auto cicp = chunk_of_png(bytes, "cICP"); cicp && cicp->size() == 4)
    return by_code_points(path, big_endian(cicp->substr(0, 1)), big_endian(cicp->substr(1, 1)));
  const auto xy = chunk_of_png(bytes, "cHRM");
  if (!xy || xy->size() != 32 || chunk_of_png(bytes, "sRGB")) return std::nullopt;
  std::array<double, 8> all{};  // white comes last here, but first in the file
  for (std::size_t i = 0; i < all.size(); ++i)
    all[(i + 6) % 8] = big_endian(xy->substr(4 * i, 4)) / 1e5;
  const std::string says = spec.get_string_attribute("oiio:ColorSpace");
  std::optional<double> power;
  if (says == "linear" || says == "Linear") power = 1;
  if (says.starts_with("Gamma")) power = spec.get_float_attribute("oiio:Gamma", 2.2F);
  return ColourProfile::of_primaries(all, power);
}

/// Contents of the named chunk of a WebP file; nothing if there is no such chunk.
std::optional<std::string_view> chunk_of_webp(std::string_view all, std::string_view name) {
  for (std::size_t at = 12; at + 8 <= all.size();) {
    std::string size_bytes(all.substr(at + 4, 4));
    std::reverse(size_bytes.begin(), size_bytes.end());
    const auto size = big_endian(size_bytes);
    if (size > all.size() - at - 8) return std::nullopt;
    if (all.substr(at, 4) == name) return all.substr(at + 8, size);
    at += std::size_t{8} + size + size % 2;
  }
  return std::nullopt;
}

/// Honours the orientation and the colour profile in a WebP file's header, which OpenImageIO ignores.
void heed_webp(const fs::path& path, Storage& storage) {
  const auto bytes = files::bytes_of(path);
  if (auto exif = chunk_of_webp(bytes, "EXIF")) {
    if (exif->starts_with("Exif")) exif->remove_prefix(6);
    OIIO::ImageSpec said;
    OIIO::decode_exif(OIIO::string_view(exif->data(), exif->size()), said);
    storage.orientation = said.get_int_attribute("Orientation", 1);
  }
  if (const auto icc = chunk_of_webp(bytes, "ICCP"))
    storage.colours = ColourProfile::of_icc(*icc, 3);
}

/// Colour profile of an OpenEXR file according to `colorInteropID` or, if that is absent, `chromaticities`.
Colours exr_colours(const OIIO::ImageSpec& spec) {
  const std::string id = spec.get_string_attribute("colorInteropID");
  if (id == "data") return std::nullopt;
  if (const auto known = primaries_of(id)) return ColourProfile::of_primaries(*known, 1);
  if (!id.empty() && id != "unknown") {
    std::string allowed = "data, unknown";
    for (const auto& space : named_spaces) allowed += ", " + std::string(space.id);
    throw algebra::Error(fmt::format("colorInteropID = {:?}, allowed {}", id, allowed));
  }
  std::array<float, 8> xy{};
  const auto type = OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8);
  if (!spec.getattribute("chromaticities", type, xy.data())) return std::nullopt;
  std::array<double, 8> all{};
  std::copy(xy.begin(), xy.end(), all.begin());
  return ColourProfile::of_primaries(all, 1);
}

Colours colours_of(const fs::path& path, const OIIO::ImageInput& input) {
  constexpr int uncalibrated = 65535;  // value of EXIF's ColorSpace for Adobe RGB
  const auto& spec = input.spec();
  const std::size_t channels = spec.nchannels < 3 ? 1 : 3;
  const std::string_view format = input.format_name();
  if (const auto icc = icc_of(spec)) return ColourProfile::of_icc(*icc, channels);
  if (format == "heif") return heif_colours(path, channels);
  if (channels == 1) return std::nullopt;
  if (format == "png") return png_colours(path, spec);
  if (format == "openexr") return exr_colours(spec);
  if (spec.get_int_attribute("Exif:ColorSpace") == uncalibrated) return ColourProfile::adobe_rgb();
  return std::nullopt;
}

}  // namespace

Storage storage_of(const fs::path& path, const OIIO::ImageInput& input) {
  Storage storage;
  const std::string_view format = input.format_name();
  if (format == "raw") return storage;  // LibRaw itself handles raw files
  storage.orientation = input.spec().get_int_attribute("Orientation", 1);
  if (format == "tiff") heed_tiff(path, input.spec(), storage);
  try {
    storage.colours = colours_of(path, input);
    if (format == "webp") heed_webp(path, storage);
  } catch (const algebra::Error& error) {
    const std::string_view what = error.what();
    if (what.starts_with(path.string())) throw;
    throw cannot_read(path, what);
  }
  if (storage.orientation < 1 || storage.orientation > 8) storage.orientation = 1;
  return storage;
}

void turn_upright(std::span<const float> stored, std::size_t width, std::size_t height,
                  int orientation, std::span<float> turned) {
  const std::size_t channels = stored.size() / (width * height);
  const auto is_one_of = [&](std::initializer_list<int> all) {
    return std::find(all.begin(), all.end(), orientation) != all.end();
  };
  const bool on_side = orientation >= 5, from_right = is_one_of({2, 3, 7, 8}),
             from_below = is_one_of({3, 4, 6, 7});
  const std::size_t rows = on_side ? width : height, columns = on_side ? height : width;
  auto put = turned.begin();
  for (std::size_t r = 0; r < rows; ++r)
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t y = on_side ? c : r, x = on_side ? r : c;
      const auto from =
          (from_below ? height - 1 - y : y) * width + (from_right ? width - 1 - x : x);
      put = std::copy_n(&stored[from * channels], channels, put);
    }
}

}  // namespace coppermoon::texture
