// SPDX-License-Identifier: MIT
#include "texture/openimageio/encode.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <array>
#include <limits>
#include <system_error>

#include "algebra/error.h"
#include "files/whole_file.h"
#include "texture/openimageio/oiio_attributes.h"
#include "texture/openimageio/silence.h"
#include "texture/seal.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;

/// Passes the bytes from OpenImageIO to a file, and remembers the system's error if one occurs.
class FileSink : public OIIO::Filesystem::IOProxy {
 public:
  explicit FileSink(const files::Handle& file) : IOProxy("", Write), file_(file) {}
  /// The type must not be "file", because OpenImageIO's JPEG writer would then take this object for its own IOFile.
  const char* proxytype() const override { return "handle"; }
  std::size_t write(const void* bytes, std::size_t size) override {
    const auto written = pwrite(bytes, size, m_pos);
    m_pos += static_cast<std::int64_t>(written);
    return written;
  }
  std::size_t pwrite(const void* bytes, std::size_t size, std::int64_t offset) override {
    const auto place = static_cast<std::uint64_t>(offset);
    if (!refusal_)
      refusal_ = files::write_at(file_, place, {static_cast<const char*>(bytes), size});
    if (refusal_) return 0;
    size_ = std::max<std::size_t>(size_, place + size);
    return size;
  }
  std::size_t size() const override { return size_; }
  std::error_code refusal() const { return refusal_; }

 private:
  const files::Handle& file_;
  std::error_code refusal_;
  std::size_t size_ = 0;
};

std::string one_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.empty() ? "unknown reason" : text;
}

/// Closes an output and returns its error message, which must always be fetched, or OpenImageIO prints it at exit.
std::string closing_words(OIIO::ImageOutput& output, bool written) {
  const bool closed = output.close();
  const auto reason = output.geterror() + OIIO::geterror();
  return written && closed ? "" : one_line(reason);
}

}  // namespace

std::size_t Source::rows_at_once() const {
  constexpr std::size_t most_values = 4 << 20, packed_together = 64;
  return std::max(packed_together, most_values / row_length() / packed_together * packed_together);
}

void Source::make(Band& band) const {
  const std::size_t count = std::min(rows_at_once(), layout.height - band.first_row);
  band.values.resize(count * row_length());
  rows(band.first_row, band.values);
  require_all(band.values, band.first_row);
}

void Source::require_all(std::span<const float> values, std::size_t first_row) const {
  tbb::parallel_for(std::size_t{0}, values.size() / row_length(), [&](std::size_t r) {
    require_values(first_row + r, values.subspan(r * row_length(), row_length()));
  });
}

void Source::require_values(std::size_t row, std::span<const float> values) const {
  bool sound = true;
  for (const float value : values) sound &= limits.hold(value);
  if (sound) return;
  const auto wrong = std::ranges::find_if(values, [&](float v) { return !limits.hold(v); });
  const auto at = static_cast<std::size_t>(wrong - values.begin());
  const auto& channels = layout.channels;
  throw Error(fmt::format("{}: texel row {}, column {}, channel {} = {}, allowed {:g} to {:g}",
                          path.string(), row, at / channels.size(), channels[at % channels.size()],
                          *wrong, limits.lowest, limits.highest));
}

void Source::for_each_band(const std::function<void(const Band&)>& act) const {
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

OIIO::ImageSpec spec_of(const Layout& layout, OIIO::TypeDesc type, const Attributes& attributes) {
  OIIO::ImageSpec spec(static_cast<int>(layout.width), static_cast<int>(layout.height),
                       static_cast<int>(layout.channels.size()), type);
  spec.channelnames = layout.channels;
  spec.alpha_channel = -1;
  for (const auto& [name, value] : attributes) set_attribute(spec, name, value);
  return spec;
}

float highest_of(ExrType type) {
  return type == ExrType::half ? 65504.0F : std::numeric_limits<float>::max();
}

OIIO::ImageSpec exr_spec(const Layout& layout, ExrType type, const Attributes& attributes) {
  auto spec = spec_of(layout, type == ExrType::half ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT,
                      attributes);
  if (!attributes.contains("capDate"))
    spec.attribute("DateTime", "");  // otherwise OpenImageIO writes the current time
  spec.attribute(seal_attribute, unsealed);
  return spec;
}

bool write_scanlines(OIIO::ImageOutput& output, const Source& source) {
  bool written = true;
  source.for_each_band([&](const Band& band) {
    const auto begin = static_cast<int>(band.first_row);
    const auto count = static_cast<int>(band.values.size() / source.row_length());
    written = written && output.write_scanlines(begin, begin + count, 0, OIIO::TypeDesc::FLOAT,
                                                band.values.data());
  });
  return written;
}

void write_encoded(const std::filesystem::path& path, const char* format,
                   const std::function<bool(OIIO::ImageOutput&, const std::string&)>& encode) {
  const auto fail = [&](std::string_view reason) {
    throw Error(fmt::format("{}: cannot be written: {}", path.string(), reason));
  };
  files::write_whole(path, [&](const files::Handle& file) {
    FileSink sink(file);
    auto output = OIIO::ImageOutput::create(format);
    if (!output) fail(one_line(OIIO::geterror()));
    const bool reads_back = std::string_view(format) == "tiff";  // TIFF needs a path, not a sink
    if (!reads_back) output->set_ioproxy(&sink);
    std::string reason;
    try {
      const bool written = encode(*output, files::name_of(file));
      reason = closing_words(*output, written);
    } catch (...) {
      const Silence silence;  // libpng prints a message if a picture ends early
      closing_words(*output, false);
      throw;
    }
    output.reset();  // the destructor, not close(), writes the end of a mip-mapped file
    if (sink.refusal()) reason = sink.refusal().message();
    if (!reason.empty()) fail(reason);
    if (std::string_view(format) == "openexr") seal(file, path);
  });
}

}  // namespace coppermoon::texture
