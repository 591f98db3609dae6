// SPDX-License-Identifier: MIT
#include "texture/write_image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "algebra/error.h"
#include "texture/openimageio/encode.h"
#include "texture/openimageio/oiio_attributes.h"
#include "texture/seal.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;

Layout layout_of(const std::filesystem::path& path, const Image& image) {
  if (image.values.size() != image.width * image.height * image.channels.size())
    throw Error(fmt::format(
        "{}: image of {} x {} texels, {} channels and {} values, allowed as "
        "many values as the others say",
        path.string(), image.width, image.height, image.channels.size(), image.values.size()));
  return {image.width, image.height, image.channels};
}

/// Converts an attribute to text, the only kind that a PNG's header can hold.
std::string as_text(const Attribute& value) {
  if (const auto* number = std::get_if<float>(&value)) return fmt::format("{}", *number);
  if (const auto* number = std::get_if<int>(&value)) return fmt::format("{}", *number);
  if (const auto* list = std::get_if<std::vector<float>>(&value))
    return fmt::format("{}", fmt::join(*list, " "));
  return std::get<std::string>(value);
}

bool is_png(const PictureFormat& format) { return std::string_view(format.name) == "png"; }

void require_format(const std::filesystem::path& path, const Layout& layout,
                    const PictureFormat& format) {
  require_layout(path, layout);
  const auto kind = is_png(format) ? "PNG" : "JPEG";
  if (format.bits != 8 && !(is_png(format) && format.bits == 16))
    throw Error(fmt::format("{}: {} of {} bits, allowed {}", path.string(), kind, format.bits,
                            is_png(format) ? "8 or 16" : "8"));
  if (layout.channels.size() != 1 && layout.channels.size() != 3)
    throw Error(fmt::format("{}: {} of {} channels, allowed 1 or 3", path.string(), kind,
                            layout.channels.size()));
}

/// Sets the date and the exposure as EXIF attributes; no other attributes are set.
void set_exposure(OIIO::ImageSpec& spec, const Attributes& attributes) {
  spec.attribute("DateTime", "");  // otherwise OpenImageIO writes the current time
  for (const auto& name : {"capDate", "expTime", "aperture"})
    if (const auto found = attributes.find(name); found != attributes.end())
      set_attribute(spec, found->first, found->second);
  if (const auto iso = attributes.find("isoSpeed"); iso != attributes.end())
    spec.attribute("Exif:PhotographicSensitivity", static_cast<int>(std::get<float>(iso->second)));
}

void require_parts(const std::filesystem::path& path, std::span<const Part> parts) {
  std::vector<std::string> names;
  for (const auto& part : parts) {
    require_layout(path, part.layout);
    names.push_back(part.name);
  }
  std::sort(names.begin(), names.end());
  if (names.empty() || std::adjacent_find(names.begin(), names.end()) != names.end())
    throw Error(fmt::format("{}: parts {}, allowed at least one, each name once", path.string(),
                            fmt::join(names, ", ")));
}

}  // namespace

void write_exr(const std::filesystem::path& path, std::span<const Part> parts,
               const Attributes& attributes, const ExrOptions& options) {
  require_parts(path, parts);
  std::vector<OIIO::ImageSpec> specs;
  for (const auto& part : parts) {
    const auto [type, negative, packed] = part.options.value_or(options);
    specs.push_back(exr_spec(part.layout, type, attributes));
    specs.back().attribute("compression", !packed ? "none" : type == ExrType::half ? "piz" : "zip");
    for (const auto& name : part.left_out) specs.back().erase_attribute(oiio_name(name));
    for (const auto& [name, value] : part.own) set_attribute(specs.back(), name, value);
    if (!part.name.empty()) specs.back().attribute("oiio:subimagename", part.name);
    if (specs.size() > 1) specs.back().erase_attribute(seal_attribute);  // kept in first part only
  }
  write_encoded(path, "openexr", [&](OIIO::ImageOutput& output, const std::string& name) {
    bool written = specs.size() == 1
                       ? output.open("", specs.front())
                       : output.open(name, static_cast<int>(specs.size()), specs.data());
    for (std::size_t i = 0; i < parts.size() && written; ++i) {
      if (i > 0) written = output.open(name, specs[i], OIIO::ImageOutput::AppendSubimage);
      const auto [type, negative, packed] = parts[i].options.value_or(options);
      const float highest = highest_of(type);
      const Source source{path, parts[i].layout, parts[i].rows, {negative ? -highest : 0, highest}};
      written = written && write_scanlines(output, source);
    }
    return written;
  });
}

void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes,
               const ExrOptions& options) {
  write_exr(path, layout_of(path, image), rows_of(image), attributes, options);
}

void write_picture(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                   const PictureFormat& format, const Attributes& attributes) {
  require_format(path, layout, format);
  auto spec =
      spec_of(layout, format.bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16, {});
  if (is_png(format)) {
    for (const auto& [name, value] : attributes)
      if (name != "colorInteropID") spec.attribute(oiio_name(name), as_text(value));  // PNG is sRGB
    // Compression level 4 takes a third of the usual time for 8 % more bytes. Filter 0x20 stores each row as
    // differences from the row above.
    spec.attribute("png:compressionLevel", 4);
    spec.attribute("png:filter", 0x20);
  } else {
    set_exposure(spec, attributes);
    if (const float time_s = spec.get_float_attribute("ExposureTime"); time_s > 0 && time_s < 1)
      // OpenImageIO 2.4 writes 1/2, 1/4 etc. as fractions without a denominator, so the time is made slightly longer.
      spec.attribute("ExposureTime", std::nextafter(time_s, 1.F));
    spec.attribute("compression", "jpeg:95");
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  spec.attribute("oiio:ColorSpace", "sRGB");
  if (format.bits == 8) spec.attribute("oiio:dither", 1);
  write_encoded(path, format.name, [&](OIIO::ImageOutput& output, const std::string&) {
    return output.open("", spec) && write_scanlines(output, {path, layout, rows, {0, 1}});
  });
}

void write_png(const std::filesystem::path& path, const Image& image, int bits,
               const Attributes& attributes) {
  const auto layout = layout_of(path, image);
  const PictureFormat format{"png", bits};
  require_format(path, layout, format);
  const auto rows = rows_of(image);
  Source{path, layout, rows, {0, 1}}.require_all(image.values);  // check before creating the file
  write_picture(path, layout, rows, format, attributes);
}

void write_tiff(const std::filesystem::path& path, const Image& image,
                const Attributes& attributes) {
  const auto layout = layout_of(path, image);
  require_layout(path, layout);
  auto spec = spec_of(layout, OIIO::TypeDesc::UINT16, {});
  set_exposure(spec, attributes);
  spec.attribute("oiio:ColorSpace", "Linear");
  spec.attribute("compression", "zip");
  const auto rows = rows_of(image);
  const Source source{path, layout, rows, {0, 1}};
  source.require_all(image.values);
  write_encoded(path, "tiff", [&](OIIO::ImageOutput& output, const std::string& name) {
    return output.open(name, spec) && write_scanlines(output, source);
  });
}

}  // namespace coppermoon::texture
