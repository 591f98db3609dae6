// SPDX-License-Identifier: MIT
#include "texture/write_image.h"

#include <OpenImageIO/filesystem.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>
#include <system_error>

#include "algebra/error.h"
#include "texture/oiio_attributes.h"
#include "texture/whole_file.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;

/// Takes the bytes OpenImageIO writes, and keeps the reason when the system refuses them.
class FileSink : public OIIO::Filesystem::IOProxy {
 public:
  explicit FileSink(int descriptor) : IOProxy("", Write), descriptor_(descriptor) {}
  const char* proxytype() const override { return "file"; }
  std::size_t write(const void* bytes, std::size_t size) override {
    const auto written = pwrite(bytes, size, m_pos);
    m_pos += static_cast<std::int64_t>(written);
    return written;
  }
  std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t offset) override {
    const auto* from = static_cast<const char*>(bytes);
    std::size_t done = 0;
    while (done < size && refusal_ == 0) {
      const auto n = ::pwrite(descriptor_, from + done, size - done,
                              static_cast<off_t>(offset + static_cast<std::int64_t>(done)));
      if (n < 0 && errno != EINTR) refusal_ = errno;
      if (n > 0) done += static_cast<std::size_t>(n);
    }
    size_ = std::max(size_, static_cast<std::size_t>(offset) + done);
    return done;
  }
  std::size_t size() const override { return size_; }
  int refusal() const { return refusal_; }

 private:
  int descriptor_, refusal_ = 0;
  std::size_t size_ = 0;
};

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "unknown reason" : text;
}

/// Whether OpenImageIO wrote it all; its error is fetched in any case, or it would print it at the
/// end.
std::string encoded(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec, const Image& image) {
  const bool written =
      output.open("", spec) && output.write_image(OIIO::TypeDesc::FLOAT, image.values.data());
  const bool closed = output.close();
  const auto reason = output.geterror() + OIIO::geterror();
  return written && closed ? "" : one_line(reason);
}

void write_through(const std::filesystem::path& path, const char* format, OIIO::ImageSpec spec,
                   const Image& image) {
  const auto output = OIIO::ImageOutput::create(format);
  if (!output)
    throw Error(
        fmt::format("{}: cannot be written: {}", path.string(), one_line(OIIO::geterror())));
  write_whole(path, [&](int descriptor) {
    FileSink sink(descriptor);
    OIIO::Filesystem::IOProxy* proxy = &sink;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, static_cast<void*>(&proxy));
    auto reason = encoded(*output, spec, image);
    if (sink.refusal() != 0) reason = std::generic_category().message(sink.refusal());
    if (!reason.empty())
      throw Error(fmt::format("{}: cannot be written: {}", path.string(), reason));
  });
}

void require_texels(const std::filesystem::path& path, const Image& image) {
  const auto texels = image.width * image.height;
  if (texels == 0 || image.channels.empty() ||
      image.values.size() != texels * image.channels.size())
    throw Error(fmt::format(
        "{}: image of {} x {} texels, {} channels and {} values, allowed as many "
        "values as the others say, and at least one",
        path.string(), image.width, image.height, image.channels.size(), image.values.size()));
  auto names = image.channels;
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end() || names.front().empty())
    throw Error(fmt::format("{}: channel \"{}\", allowed each name once and none empty",
                            path.string(), twice != names.end() ? *twice : ""));
}

void require_values(const std::filesystem::path& path, const Image& image, float lowest,
                    float highest) {
  const auto wrong = std::find_if(image.values.begin(), image.values.end(),
                                  [&](float v) { return !(v >= lowest && v <= highest); });
  if (wrong == image.values.end()) return;
  const auto at = static_cast<std::size_t>(wrong - image.values.begin());
  const auto texel = at / image.channels.size();
  throw Error(fmt::format("{}: texel row {}, column {}, channel {} = {:g}, allowed {:g} to {:g}",
                          path.string(), texel / image.width, texel % image.width,
                          image.channels[at % image.channels.size()], *wrong, lowest, highest));
}

OIIO::ImageSpec spec_of(const Image& image, OIIO::TypeDesc type, const Attributes& attributes) {
  OIIO::ImageSpec spec(static_cast<int>(image.width), static_cast<int>(image.height),
                       static_cast<int>(image.channels.size()), type);
  spec.channelnames = image.channels;
  spec.alpha_channel = -1;
  for (const auto& [name, value] : attributes) set_attribute(spec, name, value);
  return spec;
}

}  // namespace

void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes,
               const ExrOptions& options) {
  const bool half = options.type == ExrType::half;
  const float highest = half ? 65504.0F : std::numeric_limits<float>::max();
  require_texels(path, image);
  require_values(path, image, options.allow_negative ? -highest : 0, highest);
  auto spec = spec_of(image, half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT, attributes);
  spec.attribute("compression", half ? "piz" : "zip");
  if (!attributes.contains("capDate"))
    spec.attribute("DateTime", "");  // or it would be the clock's
  write_through(path, "openexr", spec, image);
}

void write_png(const std::filesystem::path& path, const Image& image, int bits,
               const Attributes& attributes) {
  require_texels(path, image);
  if (bits != 8 && bits != 16)
    throw Error(fmt::format("{}: PNG of {} bits, allowed 8 or 16", path.string(), bits));
  if (image.channels.size() != 1 && image.channels.size() != 3)
    throw Error(fmt::format("{}: PNG of {} channels, allowed 1 or 3", path.string(),
                            image.channels.size()));
  require_values(path, image, 0, 1);
  auto spec =
      spec_of(image, bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16, attributes);
  spec.attribute("oiio:ColorSpace", "sRGB");
  write_through(path, "png", spec, image);
}

}  // namespace coppermoon::texture
