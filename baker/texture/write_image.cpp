// SPDX-License-Identifier: MIT
#include "texture/write_image.h"

#include <OpenImageIO/filesystem.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <unistd.h>

#include <algorithm>
#include <array>
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

/// What a file's values may be.
struct Limits {
  float lowest, highest;

  bool hold(float value) const { return value >= lowest && value <= highest; }
};

/// Some rows on their way into a file.
struct Band {
  std::size_t first_row = 0;
  std::vector<float> values{};
};

/// An image to be encoded: rows are made, looked at and handed on, some at a time.
struct Source {
  const std::filesystem::path& path;
  const Layout& layout;
  const Rows& rows;
  Limits limits;

  std::size_t row_length() const { return layout.width * layout.channels.size(); }

  /// A multiple of the 32 rows that PIZ packs together.
  std::size_t rows_at_once() const {
    constexpr std::size_t most_values = 4 << 20;
    return std::max<std::size_t>(64, most_values / row_length() / 32 * 32);
  }

  void make(Band& band) const {
    const std::size_t count = std::min(rows_at_once(), layout.height - band.first_row);
    band.values.resize(count * row_length());
    rows(band.first_row, band.values);
    require_all(band.values, band.first_row);
  }

  void require_all(std::span<const float> values, std::size_t first_row = 0) const {
    tbb::parallel_for(std::size_t{0}, values.size() / row_length(), [&](std::size_t r) {
      require_values(first_row + r, values.subspan(r * row_length(), row_length()));
    });
  }

  void require_values(std::size_t row, std::span<const float> values) const {
    bool sound = true;
    for (const float value : values) sound &= limits.hold(value);
    if (sound) return;
    const auto wrong = std::ranges::find_if(values, [&](float v) { return !limits.hold(v); });
    const auto at = static_cast<std::size_t>(wrong - values.begin());
    const auto& channels = layout.channels;
    throw Error(fmt::format("{}: texel row {}, column {}, channel {} = {}, allowed {:g} to {:g}",
                            path.string(), row, at / channels.size(),
                            channels[at % channels.size()], *wrong, limits.lowest, limits.highest));
  }

  /// The next band is made while `act` is busy with one.
  void for_each_band(const std::function<void(const Band&)>& act) const {
    std::array<Band, 2> bands;
    std::size_t next = 0;
    const auto made = [&](tbb::flow_control& control) -> Band* {
      const std::size_t first_row = next * rows_at_once();
      if (first_row >= layout.height) {
        control.stop();
        return nullptr;
      }
      Band& band = bands[next++ % bands.size()];
      band.first_row = first_row;
      make(band);
      return &band;
    };
    constexpr auto in_turn = tbb::filter_mode::serial_in_order;
    tbb::parallel_pipeline(bands.size(), tbb::make_filter<void, Band*>(in_turn, made) &
                                             tbb::make_filter<Band*, void>(
                                                 in_turn, [&](const Band* band) { act(*band); }));
  }
};

/// Closes it, and fetches its error in any case, or OpenImageIO would print it at the end.
std::string closing_words(OIIO::ImageOutput& output, bool written) {
  const bool closed = output.close();
  const auto reason = output.geterror() + OIIO::geterror();
  return written && closed ? "" : one_line(reason);
}

/// Returned  why OpenImageIO did not write it all, or nothing
std::string encoded(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec, const Source& source) {
  bool written = output.open("", spec);
  try {
    if (written)
      source.for_each_band([&](const Band& band) {
        const auto begin = static_cast<int>(band.first_row);
        const auto count = static_cast<int>(band.values.size() / source.row_length());
        written = written && output.write_scanlines(begin, begin + count, 0, OIIO::TypeDesc::FLOAT,
                                                    band.values.data());
      });
  } catch (...) {
    closing_words(output, false);
    throw;
  }
  return closing_words(output, written);
}

void write_through(const char* format, OIIO::ImageSpec spec, const Source& source) {
  const auto fail = [&](std::string_view reason) {
    throw Error(fmt::format("{}: cannot be written: {}", source.path.string(), reason));
  };
  write_whole(source.path, [&](int descriptor) {
    FileSink sink(descriptor);
    OIIO::Filesystem::IOProxy* proxy = &sink;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, static_cast<void*>(&proxy));
    const auto output = OIIO::ImageOutput::create(format);
    if (!output) fail(one_line(OIIO::geterror()));
    auto reason = encoded(*output, spec, source);
    if (sink.refusal() != 0) reason = std::generic_category().message(sink.refusal());
    if (!reason.empty()) fail(reason);
  });
}

void require_layout(const std::filesystem::path& path, const Layout& layout) {
  if (layout.width == 0 || layout.height == 0 || layout.channels.empty())
    throw Error(fmt::format("{}: image of {} x {} texels and {} channels, allowed at least one",
                            path.string(), layout.width, layout.height, layout.channels.size()));
  auto names = layout.channels;
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end() || names.front().empty())
    throw Error(fmt::format("{}: channel \"{}\", allowed each name once and none empty",
                            path.string(), twice != names.end() ? *twice : ""));
}

Layout layout_of(const std::filesystem::path& path, const Image& image) {
  if (image.values.size() != image.width * image.height * image.channels.size())
    throw Error(fmt::format(
        "{}: image of {} x {} texels, {} channels and {} values, allowed as "
        "many values as the others say",
        path.string(), image.width, image.height, image.channels.size(), image.values.size()));
  return {image.width, image.height, image.channels};
}

Rows rows_of(const Image& image) {
  return [&image](std::size_t first_row, std::span<float> values) {
    const std::size_t length = image.width * image.channels.size();
    std::copy_n(&image.values[first_row * length], values.size(), values.begin());
  };
}

OIIO::ImageSpec spec_of(const Layout& layout, OIIO::TypeDesc type, const Attributes& attributes) {
  OIIO::ImageSpec spec(static_cast<int>(layout.width), static_cast<int>(layout.height),
                       static_cast<int>(layout.channels.size()), type);
  spec.channelnames = layout.channels;
  spec.alpha_channel = -1;
  for (const auto& [name, value] : attributes) set_attribute(spec, name, value);
  return spec;
}

/// A PNG's header holds nothing else.
std::string as_text(const Attribute& value) {
  if (const auto* number = std::get_if<float>(&value)) return fmt::format("{}", *number);
  if (const auto* number = std::get_if<int>(&value)) return fmt::format("{}", *number);
  if (const auto* list = std::get_if<std::vector<float>>(&value))
    return fmt::format("{}", fmt::join(*list, " "));
  return std::get<std::string>(value);
}

}  // namespace

void write_exr(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
               const Attributes& attributes, const ExrOptions& options) {
  const bool half = options.type == ExrType::half;
  const float highest = half ? 65504.0F : std::numeric_limits<float>::max();
  require_layout(path, layout);
  auto spec = spec_of(layout, half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT, attributes);
  spec.attribute("compression", !options.packed ? "none" : half ? "piz" : "zip");
  if (!attributes.contains("capDate"))
    spec.attribute("DateTime", "");  // or it would be the clock's
  write_through("openexr", spec,
                {path, layout, rows, {options.allow_negative ? -highest : 0, highest}});
}

void write_exr(const std::filesystem::path& path, const Image& image, const Attributes& attributes,
               const ExrOptions& options) {
  write_exr(path, layout_of(path, image), rows_of(image), attributes, options);
}

void write_png(const std::filesystem::path& path, const Image& image, int bits,
               const Attributes& attributes) {
  const auto layout = layout_of(path, image);
  require_layout(path, layout);
  if (bits != 8 && bits != 16)
    throw Error(fmt::format("{}: PNG of {} bits, allowed 8 or 16", path.string(), bits));
  if (image.channels.size() != 1 && image.channels.size() != 3)
    throw Error(fmt::format("{}: PNG of {} channels, allowed 1 or 3", path.string(),
                            image.channels.size()));
  auto spec = spec_of(layout, bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16, {});
  for (const auto& [name, value] : attributes) spec.attribute(oiio_name(name), as_text(value));
  spec.attribute("oiio:ColorSpace", "sRGB");
  spec.attribute("png:compressionLevel", 4);  // half of zlib's usual time, 6 % more bytes
  const auto rows = rows_of(image);
  const Source source{path, layout, rows, {0, 1}};
  source.require_all(image.values);  // libpng prints when a file ends early
  write_through("png", spec, source);
}

}  // namespace coppermoon::texture
