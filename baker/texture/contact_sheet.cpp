// SPDX-License-Identifier: MIT
#include "texture/contact_sheet.h"

#include "texture/openimageio/oiio.h"

#include <OpenImageIO/color.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <array>

#include "algebra/error.h"
#include "texture/read_image.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;
using OIIO::ImageBufAlgo::TextAlignX;
using Colour = std::array<float, 3>;

constexpr Colour bright{1.F, 0.8F, 0.45F}, dim{0.6F, 0.6F, 0.6F}, white{0.9F, 0.9F, 0.9F};
constexpr int title_size = 22, least_title_size = 9, label_size = 15;

/// Wraps an image's values in an OpenImageIO buffer without copying them.
OIIO::ImageBuf shared(Image& image) {
  return {OIIO::ImageSpec(static_cast<int>(image.width), static_cast<int>(image.height), 3,
                          OIIO::TypeDesc::FLOAT),
          image.values.data()};
}

void require_done(bool done, const OIIO::ImageBuf& buffer) {
  auto reason = buffer.geterror() + OIIO::geterror();
  reason = reason.substr(0, reason.find('\n'));
  if (!done) throw Error(fmt::format("contact sheet: {}", reason));
}

/// A line of text and its position on a sheet.
struct Line {
  const std::string& text;
  std::size_t x, y;  ///< point on the baseline to which the text is aligned
  TextAlignX held;
  int size;
  Colour colour;
};

void write_line(Image& sheet, const std::filesystem::path& font, const Line& line) {
  if (line.text.empty()) return;
  auto buffer = shared(sheet);
  require_done(
      OIIO::ImageBufAlgo::render_text(buffer, static_cast<int>(line.x), static_cast<int>(line.y),
                                      line.text, line.size, font.string(), line.colour, line.held),
      buffer);
}

/// Font size of a title: the usual size, or a smaller but still legible one if the title is too wide for the sheet. An
/// empty title gets the usual size, because OpenImageIO cannot measure it.
int fitting_size(const Image& sheet, const ContactSheet& of) {
  if (of.title.empty()) return title_size;
  const auto room = static_cast<int>(sheet.width - 2 * SheetGrid::gap);
  int size = title_size;
  const auto fits = [&] {
    const auto box = OIIO::ImageBufAlgo::text_size(of.title, size, of.font.string());
    return !box.defined() || box.width() <= room;
  };
  while (size > least_title_size && !fits()) --size;
  return size;
}

/// Scales a picture down to the size of a sheet's pictures by averaging linear light. The result is linear.
Image thumbnail(Image picture, const SheetGrid& grid) {
  for (float& value : picture.values) value = OIIO::sRGB_to_linear(value);
  Image small(SheetGrid::picture_width, grid.picture_height, picture.channels);
  const auto source = shared(picture);
  auto target = shared(small);
  require_done(OIIO::ImageBufAlgo::resize(target, source, "triangle"), target);
  return small;
}

Image read_picture(const std::filesystem::path& file) {
  auto picture = read_image(file);
  if (picture.channels.size() != 3)
    throw Error(fmt::format("{}: picture of {} channels, allowed 3", file.string(),
                            picture.channels.size()));
  return picture;
}

void put(Image& sheet, const Image& small, std::size_t left, std::size_t top) {
  for (std::size_t r = 0; r < small.height; ++r)
    for (std::size_t c = 0; c < small.width; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        sheet(top + r, left + c, k) = std::clamp(OIIO::linear_to_sRGB(small(r, c, k)), 0.F, 1.F);
}

void label(Image& sheet, const ContactSheet& of, const SheetGrid& grid, std::size_t index) {
  const auto& picture = of.pictures[index];
  const std::size_t left = grid.left(index), right = left + SheetGrid::picture_width,
                    y = grid.top(index) + grid.picture_height + SheetGrid::baseline;
  const auto colour = picture.marked ? bright : dim;
  write_line(sheet, of.font, {picture.left, left, y, TextAlignX::Left, label_size, colour});
  write_line(sheet, of.font, {picture.right, right, y, TextAlignX::Right, label_size, colour});
}

}  // namespace

std::filesystem::path sheet_font() {
  constexpr std::array known{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                             "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
                             "/usr/share/fonts/TTF/DejaVuSans.ttf",
                             "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
                             "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
                             "/usr/local/share/fonts/DejaVuSans.ttf",
                             "C:/Windows/Fonts/arial.ttf",
                             "C:/Windows/Fonts/tahoma.ttf"};
  for (std::filesystem::path font : known)
    if (std::filesystem::exists(font)) return font;
  throw Error(
      fmt::format("{}: no such font, nor others; install the package fonts-dejavu-core", known[0]));
}

void write_captions(Image& picture, const std::string& left, const std::string& right, float grey,
                    const std::filesystem::path& font) {
  const auto least = static_cast<std::size_t>(least_title_size);
  auto size = std::max(least, picture.height / 36);
  const auto width = [&](const std::string& text) {
    const auto box =
        text.empty() ? OIIO::ROI()
                     : OIIO::ImageBufAlgo::text_size(text, static_cast<int>(size), font.string());
    return box.defined() ? static_cast<std::size_t>(box.width()) : 0;
  };
  while (size > least && width(left) + width(right) + 3 * size > picture.width) --size;
  const std::size_t y = std::max(size, picture.height) - size, x = std::min(size, picture.width);
  const Colour colour{grey, grey, grey};
  const auto letters = static_cast<int>(size);
  write_line(picture, font, {left, x, y, TextAlignX::Left, letters, colour});
  write_line(picture, font, {right, picture.width - x, y, TextAlignX::Right, letters, colour});
  for (float& value : picture.values) value = std::clamp(value, 0.F, 1.F);
}

Image drawn(const ContactSheet& of) {
  if (of.pictures.empty()) throw Error("contact sheet of 0 pictures, allowed 1 or more");
  Image sheet;
  SheetGrid grid{};
  for (std::size_t i = 0; i < of.pictures.size(); ++i) {
    auto picture = read_picture(of.pictures[i].file);
    if (i == 0) {
      grid = sheet_grid(of.pictures.size(), of.columns, picture.width, picture.height);
      sheet = Image(grid.width(), grid.height(), {"R", "G", "B"});
    }
    put(sheet, thumbnail(std::move(picture), grid), grid.left(i), grid.top(i));
    label(sheet, of, grid, i);
  }
  write_line(sheet, of.font,
             {of.title, SheetGrid::gap, SheetGrid::title_baseline, TextAlignX::Left,
              fitting_size(sheet, of), white});
  for (float& value : sheet.values) value = std::clamp(value, 0.F, 1.F);
  return sheet;
}

}  // namespace coppermoon::texture
