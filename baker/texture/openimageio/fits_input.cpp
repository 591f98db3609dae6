// SPDX-License-Identifier: MIT
#include "texture/openimageio/fits_input.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"

namespace coppermoon::texture {
namespace {

using algebra::Error;

constexpr std::size_t card = 80, block = 2880, most_blocks = 1000;

/// Values of a header by their keywords.
using Cards = std::map<std::string, std::string, std::less<>>;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == text.npos ? std::string_view() : text.substr(first, last - first + 1);
}

/// A card's value without its comment, a text without its quotes.
std::string value_in(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('\'')) return std::string(trimmed(text.substr(1, text.find('\'', 1) - 1)));
  return std::string(trimmed(text.substr(0, text.find('/'))));
}

/// Reads a header, to the end of its last block.
Cards cards_in(std::istream& file) {
  Cards cards;
  std::string text(block, '\0');
  for (std::size_t i = 0; i < most_blocks && file.read(text.data(), block); ++i)
    for (std::size_t at = 0; at < block; at += card) {
      const auto line = std::string_view(text).substr(at, card);
      const auto name = trimmed(line.substr(0, 8));
      if (name == "END") return cards;
      if (line.substr(8, 2) == "= ") cards.emplace(name, value_in(line.substr(10)));
    }
  throw Error("a FITS header without an end");
}

double number_of(const Cards& cards, const std::string& name, std::optional<double> otherwise) {
  const auto found = cards.find(name);
  if (found == cards.end() && otherwise) return *otherwise;
  const auto text = found == cards.end() ? std::string() : found->second;
  auto plain = text;
  std::ranges::replace(plain, 'D', 'E');
  const auto number = algebra::number_in(plain);
  if (!number) throw Error(fmt::format("{} = {}, allowed a number", name, text));
  return *number;
}

/// A big-endian number of a file.
template <class Unsigned>
Unsigned bits_at(const char* bytes) {
  Unsigned bits = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
    bits = static_cast<Unsigned>(bits << 8 | static_cast<unsigned char>(bytes[i]));
  return bits;
}

double stored_at(const char* bytes, int bitpix) {
  switch (bitpix) {
    case 8:
      return static_cast<unsigned char>(*bytes);
    case 16:
      return static_cast<std::int16_t>(bits_at<std::uint16_t>(bytes));
    case 32:
      return static_cast<std::int32_t>(bits_at<std::uint32_t>(bytes));
    case -32:
      return static_cast<double>(std::bit_cast<float>(bits_at<std::uint32_t>(bytes)));
    default:
      return std::bit_cast<double>(bits_at<std::uint64_t>(bytes));
  }
}

/// Layout and scale of an image, from its header.
struct Header {
  int bitpix, width, height, planes;
  double zero, scale, full;  ///< full: what stands for 1
  std::optional<double> blank;
  bool first_row_on_top;
};

int axis_of(const Cards& cards, const std::string& name) {
  const double length = number_of(cards, name, {});
  if (!(length >= 1 && length <= 1 << 20 && length == std::floor(length)))
    throw Error(fmt::format("{} = {:g}, allowed 1 to {}", name, length, 1 << 20));
  return static_cast<int>(length);
}

Header header_of(const Cards& cards) {
  const double bitpix = number_of(cards, "BITPIX", {}), axes = number_of(cards, "NAXIS", {});
  if (bitpix != 8 && bitpix != 16 && bitpix != 32 && bitpix != -32 && bitpix != -64)
    throw Error(fmt::format("BITPIX = {:g}, allowed 8, 16, 32, -32, -64", bitpix));
  if (axes != 2 && axes != 3)
    throw Error(fmt::format("NAXIS = {:g}, allowed 2 or 3, of the file's first image", axes));
  Header header{.bitpix = static_cast<int>(bitpix),
                .width = axis_of(cards, "NAXIS1"),
                .height = axis_of(cards, "NAXIS2"),
                .planes = axes == 3 ? axis_of(cards, "NAXIS3") : 1,
                .zero = number_of(cards, "BZERO", 0),
                .scale = number_of(cards, "BSCALE", 1),
                .full = 1,
                .blank = {},
                .first_row_on_top = false};
  if (header.planes != 1 && header.planes != 3)
    throw Error(fmt::format("NAXIS3 = {}, allowed 1, or 3 for red, green and blue", header.planes));
  if (const auto mosaic = cards.find("BAYERPAT"); mosaic != cards.end() && header.planes == 1)
    throw Error(fmt::format("BAYERPAT = {}, a mosaic of colours, allowed are colours of each pixel",
                            mosaic->second));
  if (header.bitpix > 0 && header.scale == 1)
    header.full = header.zero + (header.bitpix == 8 ? 255 : std::exp2(header.bitpix - 1) - 1);
  if (!(header.full > 0 && std::isfinite(header.full) && std::isfinite(header.scale)))
    throw Error(fmt::format("BZERO = {:g}, allowed what leaves light above 0", header.zero));
  if (header.bitpix > 0 && cards.contains("BLANK")) header.blank = number_of(cards, "BLANK", {});
  const auto order = cards.find("ROWORDER");
  header.first_row_on_top = order != cards.end() && order->second == "TOP-DOWN";
  return header;
}

class FitsInput : public OIIO::ImageInput {
 public:
  const char* format_name() const override { return "fits"; }

  bool open(const std::string& name, OIIO::ImageSpec& spec) override try {
    file_.open(name, std::ios::binary);
    const auto cards = cards_in(file_);
    header_ = header_of(cards);
    begin_ = file_.tellg();
    row_bytes_ = static_cast<std::size_t>(header_.width) *
                 static_cast<std::size_t>(std::abs(header_.bitpix) / 8);
    if (static_cast<double>(std::filesystem::file_size(name)) <
        static_cast<double>(begin_) +
            1. * static_cast<double>(row_bytes_) * header_.height * header_.planes)
      throw Error("it ends early");
    m_spec = {header_.width, header_.height, header_.planes, OIIO::TypeDesc::FLOAT};
    m_spec.channelnames = header_.planes == 3 ? std::vector<std::string>{"R", "G", "B"}
                                              : std::vector<std::string>{"Y"};
    m_spec.attribute("oiio:ColorSpace", "Linear");
    spec = m_spec;
    return true;
  } catch (const Error& error) {
    errorfmt("{}", error.what());
    return false;
  }

  bool close() override {
    file_.close();
    return true;
  }

  bool read_native_scanline(int, int, int y, int, void* data) override {
    auto* values = static_cast<float*>(data);
    std::string row(row_bytes_, '\0');
    const auto bytes = static_cast<std::size_t>(std::abs(header_.bitpix) / 8);
    const int stored_row = header_.first_row_on_top ? y : header_.height - 1 - y;
    for (int plane = 0; plane < header_.planes; ++plane) {
      file_.seekg(begin_ + static_cast<std::streamoff>(row_bytes_) *
                               (static_cast<std::streamoff>(plane) * header_.height + stored_row));
      if (!file_.read(row.data(), static_cast<std::streamsize>(row.size()))) {
        errorfmt("it ends early");
        return false;
      }
      for (int x = 0; x < header_.width; ++x)
        values[x * header_.planes + plane] =
            light(stored_at(row.data() + static_cast<std::size_t>(x) * bytes, header_.bitpix));
    }
    return true;
  }

 private:
  float light(double stored) const {
    if (header_.blank && stored == *header_.blank) return std::numeric_limits<float>::quiet_NaN();
    return static_cast<float>((header_.zero + header_.scale * stored) / header_.full);
  }

  std::ifstream file_;
  std::streamoff begin_ = 0;
  std::size_t row_bytes_ = 0;
  Header header_{};
};

}  // namespace

std::unique_ptr<OIIO::ImageInput> fits_input() { return std::make_unique<FitsInput>(); }

}  // namespace coppermoon::texture
