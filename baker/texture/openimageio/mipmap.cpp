// SPDX-License-Identifier: MIT
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "texture/openimageio/encode.h"
#include "texture/write_image.h"

namespace coppermoon::texture {
namespace {

constexpr int tile_side = 64;

/// Halves a row or column of texels. `share` is the weight of one old texel in one new texel.
struct Halving {
  std::size_t from, to;

  explicit Halving(std::size_t length) : from(length), to(std::max<std::size_t>(1, length / 2)) {}
  double width() const { return static_cast<double>(from) / static_cast<double>(to); }
  std::size_t first(std::size_t texel) const { return texel * from / to; }
  std::size_t last(std::size_t texel) const { return ((texel + 1) * from - 1) / to; }
  double share(std::size_t texel, std::size_t of) const {
    const double begin = std::max(static_cast<double>(of), static_cast<double>(texel) * width());
    const double end =
        std::min(static_cast<double>(of + 1), static_cast<double>(texel + 1) * width());
    return (end - begin) / width();
  }
};

/// The next smaller level of a mip-map, filled as rows of the larger one arrive. Each texel is the mean over its area.
class NextLevel {
 public:
  explicit NextLevel(const Layout& layout)
      : image(Halving(layout.width).to, Halving(layout.height).to, layout.channels),
        columns_(layout.width),
        rows_(layout.height) {}

  void add(const Band& band) {
    const std::size_t channels = image.channels.size(), length = columns_.from * channels;
    const std::size_t end = band.first_row + band.values.size() / length;
    const std::size_t last = std::min(end * rows_.to / rows_.from, rows_.to - 1);
    tbb::parallel_for(band.first_row * rows_.to / rows_.from, last + 1, [&](std::size_t row) {
      const std::size_t from = std::max(rows_.first(row), band.first_row);
      for (std::size_t r = from; r < std::min(rows_.last(row) + 1, end); ++r)
        add_row(row, std::span(band.values).subspan((r - band.first_row) * length, length),
                rows_.share(row, r));
    });
  }

  Image image;

 private:
  void add_row(std::size_t row, std::span<const float> values, double share) {
    const std::size_t channels = image.channels.size();
    for (std::size_t column = 0; column < columns_.to; ++column)
      for (std::size_t c = columns_.first(column); c <= columns_.last(column); ++c) {
        const auto part = static_cast<float>(share * columns_.share(column, c));
        for (std::size_t k = 0; k < channels; ++k)
          image(row, column, k) += part * values[c * channels + k];
      }
  }

  Halving columns_, rows_;
};

/// Writes one level of a mip-map, and fills the next smaller level at the same time.
bool write_level(OIIO::ImageOutput& output, const Source& source, NextLevel& next) {
  bool written = true;
  const auto width = static_cast<int>(source.layout.width);
  source.for_each_band([&](const Band& band) {
    const auto begin = static_cast<int>(band.first_row);
    const auto count = static_cast<int>(band.values.size() / source.row_length());
    written = written && output.write_tiles(0, width, begin, begin + count, 0, 1,
                                            OIIO::TypeDesc::FLOAT, band.values.data());
    next.add(band);
  });
  return written;
}

OIIO::ImageSpec mipmap_spec(const Layout& layout, ExrType type, const Attributes& attributes) {
  auto spec = exr_spec(layout, type, attributes);
  spec.tile_width = spec.tile_height = tile_side;
  spec.tile_depth = 1;
  spec.attribute("compression", "zip");  // suits tiles that are read one by one
  spec.attribute("textureformat", "Plain Texture");
  spec.attribute("wrapmodes", "periodic,clamp");
  spec.attribute("openexr:roundingmode", 0);  // each level's size is half the last, rounded down
  return spec;
}

}  // namespace

void write_mipmapped(const std::filesystem::path& path, const Layout& layout, const Rows& rows,
                     const Attributes& attributes, ExrType type) {
  require_layout(path, layout);
  const auto spec = mipmap_spec(layout, type, attributes);
  write_encoded(path, "openexr", [&](OIIO::ImageOutput& output, const std::string&) {
    NextLevel next(layout);
    bool written = output.open("", spec) &&
                   write_level(output, {path, layout, rows, {0, highest_of(type)}}, next);
    for (Layout level = layout; written && std::max(level.width, level.height) > 1;) {
      const Image image = std::move(next.image);
      level = {image.width, image.height, image.channels};
      auto smaller = spec;
      smaller.width = smaller.full_width = static_cast<int>(level.width);
      smaller.height = smaller.full_height = static_cast<int>(level.height);
      next = NextLevel(level);
      written = output.open("", smaller, OIIO::ImageOutput::AppendMIPLevel) &&
                write_level(output, {path, level, rows_of(image), {0, highest_of(type)}}, next);
    }
    return written;
  });
}

}  // namespace coppermoon::texture
