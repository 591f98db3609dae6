// SPDX-License-Identifier: MIT
#include "texture/read_image.h"

#include <OpenImageIO/imageio.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "algebra/error.h"
#include "texture/image_claims.h"
#include "texture/oiio_attributes.h"

namespace coppermoon::texture {
namespace {

namespace fs = std::filesystem;
using algebra::Error;

Error cannot_read(const fs::path& path, std::string_view reason) {
  return Error(fmt::format("{}: cannot be read: {}", path.string(), reason));
}

/// The first line of what OpenImageIO says; asked in any case, or it would print it at the end.
std::string reason_of(OIIO::ImageInput* input) {
  auto text = input ? input->geterror() : std::string();
  const auto pending = OIIO::geterror();
  if (text.empty()) text = pending;
  text = text.substr(0, text.find('\n'));
  return text.empty() ? "no image, or one of an unknown kind" : text;
}

void require_readable_file(const fs::path& path) {
  std::error_code failed;
  const auto status = fs::status(path, failed);
  if (status.type() == fs::file_type::not_found) throw cannot_read(path, "no such file");
  if (failed) throw cannot_read(path, failed.message());
  if (fs::is_directory(status)) throw cannot_read(path, "it is a directory");
  if (!fs::is_regular_file(status)) throw cannot_read(path, "it is no regular file");
  if (fs::file_size(path, failed) == 0 && !failed) throw cannot_read(path, "it is empty");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) throw cannot_read(path, std::generic_category().message(errno));
}

/// A header may claim any size: the file must be able to hold it before any memory is asked for.
void require_size(const fs::path& path, const OIIO::ImageSpec& spec) {
  const auto within = [&](std::string_view what, double value, double most) {
    if (value <= most) return;
    throw cannot_read(path, fmt::format("{} = {:g}, allowed up to {:g}", what, value, most));
  };
  within("width [texels]", spec.width, most_texels_a_side);
  within("height [texels]", spec.height, most_texels_a_side);
  within("distance from the origin [texels]",
         std::max(std::abs(spec.x * 1.), std::abs(spec.y * 1.)), most_texels_a_side);
  const double numbers = 1. * spec.width * spec.height * spec.nchannels;
  within("numbers, texels by channels", numbers, most_numbers);
  const double of_this_file =
      most_numbers_of_any_file + most_numbers_a_byte * static_cast<double>(fs::file_size(path));
  within("numbers in a file so small", numbers, of_this_file);
  const double tile = 1. * spec.tile_width * spec.tile_height * spec.nchannels;
  within("numbers of a tile in a file so small", tile, of_this_file);
}

/// OpenImageIO's name for what reads a file: by its first bytes, else by its name's ending. Left alone
/// it would hand a file that one reader refuses to all of its others, films and medicine included.
std::string format_of(const fs::path& path) {
  using namespace std::string_view_literals;
  constexpr std::array<std::pair<std::string_view, const char*>, 7> known{
      {{"v/1\x01"sv, "openexr"},
       {"II*\0"sv, "tiff"},
       {"MM\0*"sv, "tiff"},
       {"II+\0"sv, "tiff"},
       {"MM\0+"sv, "tiff"},
       {"\x89PNG"sv, "png"},
       {"\xFF\xD8\xFF"sv, "jpeg"}}};
  std::array<char, 4> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  const std::string_view beginning(bytes.data(), bytes.size());
  for (const auto& [sign, format] : known)
    if (beginning.starts_with(sign)) return format;
  const auto ending = path.extension().string();
  return ending.empty() ? ending : ending.substr(1);
}

std::unique_ptr<OIIO::ImageInput> opened(const fs::path& path) {
  require_readable_file(path);
  const auto format = format_of(path);
  require_honest_claims(path, format);
  auto input = format.empty() ? nullptr : OIIO::ImageInput::create(format);
  OIIO::ImageSpec spec;
  if (!input || !input->open(path.string(), spec)) throw cannot_read(path, reason_of(input.get()));
  if (spec.deep || spec.depth > 1 || spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
    throw cannot_read(path, "not a flat image with texels");
  require_size(path, spec);
  return input;
}

/// Some rows of an image, all its channels.
template <class T>
struct RowsRead {
  std::size_t first_row, rows;
  std::vector<T> values;
};

/// Reads some 64 rows at a time, whole rows of tiles where there are tiles: memory stays small.
template <class T>
void for_all_rows(OIIO::ImageInput& input, const fs::path& path, const auto& act) {
  const auto spec = input.spec();
  constexpr auto type = OIIO::BaseTypeFromC<T>::value;
  const bool tiled = spec.tile_width > 0;
  const int step = tiled ? spec.tile_height * std::max(1, 64 / spec.tile_height) : 64;
  RowsRead<T> band;
  for (int y = 0; y < spec.height; y += step) {
    const int begin = spec.y + y, end = spec.y + std::min(y + step, spec.height);
    band.first_row = static_cast<std::size_t>(y);
    band.rows = static_cast<std::size_t>(end - begin);
    band.values.resize(band.rows * static_cast<std::size_t>(spec.width) *
                       static_cast<std::size_t>(spec.nchannels));
    const bool read = tiled ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, 0, 1,
                                               0, spec.nchannels, type, band.values.data())
                            : input.read_scanlines(0, 0, begin, end, 0, 0, spec.nchannels, type,
                                                   band.values.data());
    if (!read || input.has_error())  // of TIFF and JPEG that end early it says both
      throw cannot_read(path, reason_of(&input));
    act(band);
  }
}

/// What does not fit into memory is an error of the file's.
template <class Make>
auto within_memory(const fs::path& path, const OIIO::ImageSpec& spec, Make make) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  throw cannot_read(path, fmt::format("no memory for {} x {} texels", spec.width, spec.height));
}

/// The curve from the file's numbers to linear light: a power, or sRGB.
struct Curve {
  bool srgb;
  float power;
};

Curve curve_of(const OIIO::ImageSpec& spec, Coding coding) {
  const std::string says = spec.get_string_attribute("oiio:ColorSpace");
  if (coding == Coding::srgb) return {true, 1};
  if (coding == Coding::linear || says == "linear" || says == "Linear") return {false, 1};
  if (says.starts_with("Gamma")) return {false, spec.get_float_attribute("oiio:Gamma", 2.2F)};
  return {says == "sRGB" || !spec.format.is_floating_point(), 1};
}

float linear(float v, Curve curve) {
  if (curve.srgb) return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
  return curve.power == 1 ? v : std::pow(v, curve.power);
}

/// Which channels are red, green and blue: by name, else the first three; all the same for grey.
std::array<std::size_t, 3> rgb_channels(const OIIO::ImageSpec& spec) {
  if (spec.nchannels < 3) return {0, 0, 0};
  const std::array found{spec.channelindex("R"), spec.channelindex("G"), spec.channelindex("B")};
  if (*std::min_element(found.begin(), found.end()) < 0) return {0, 1, 2};
  return {static_cast<std::size_t>(found[0]), static_cast<std::size_t>(found[1]),
          static_cast<std::size_t>(found[2])};
}

float luminance(float red, float green, float blue) {
  return 0.2126F * red + 0.7152F * green + 0.0722F * blue;
}

/// A band's numbers as light, and a power of their luminance.
struct FloatingTone {
  using Number = float;
  Curve curve;
  float exponent;

  float grey(float v) const { return raised(linear(v, curve)); }
  float coloured(float r, float g, float b) const {
    return raised(luminance(linear(r, curve), linear(g, curve), linear(b, curve)));
  }
  float raised(float v) const { return exponent == 1 || !(v > 0) ? v : std::pow(v, exponent); }
};

/// The same for 8 bits: each of their 256 values computed once.
struct ByteTone {
  using Number = std::uint8_t;
  explicit ByteTone(const FloatingTone& of) : tone(of) {
    for (std::size_t i = 0; i < light.size(); ++i) {
      light[i] = linear(static_cast<float>(i) / 255.0F, tone.curve);
      raised_light[i] = tone.raised(light[i]);
    }
  }
  float grey(std::uint8_t v) const { return raised_light[v]; }
  float coloured(std::uint8_t r, std::uint8_t g, std::uint8_t b) const {
    if (r == g && g == b) return raised_light[r];
    return tone.raised(luminance(light[r], light[g], light[b]));
  }

  FloatingTone tone;
  std::array<float, 256> light{}, raised_light{};
};

template <class Tone>
void read_luminance(OIIO::ImageInput& input, const fs::path& path, const Tone& tone,
                    algebra::Grid<float>& map) {
  const auto [r, g, b] = rgb_channels(input.spec());
  const auto stride = static_cast<std::size_t>(input.spec().nchannels);
  const auto add = [&, r = r, g = g, b = b](const auto& band) {
    tbb::parallel_for(std::size_t{0}, band.rows, [&](std::size_t row) {
      const auto* texel = band.values.data() + row * map.columns() * stride;
      for (float& value : map.row(band.first_row + row)) {
        value = r == g ? tone.grey(texel[r]) : tone.coloured(texel[r], texel[g], texel[b]);
        texel += stride;
      }
    });
  };
  for_all_rows<typename Tone::Number>(input, path, add);
}

void require_two_to_one(const fs::path& path, const OIIO::ImageSpec& spec) {
  if (spec.width != 2 * spec.height)
    throw cannot_read(
        path, fmt::format("albedo map of {} x {} texels, allowed 2:1", spec.width, spec.height));
  if (spec.full_width != spec.width || spec.full_height != spec.height)
    throw cannot_read(path,
                      fmt::format("albedo map cropped from {} x {} texels, allowed whole ones",
                                  spec.full_width, spec.full_height));
}

/// OpenImageIO makes light of cyan, magenta, yellow and black, but not of other inks.
void require_light(const fs::path& path, const OIIO::ImageSpec& spec) {
  if (spec.channelnames[0].starts_with("ink"))
    throw cannot_read(path, "channels of inks, allowed grey, colours of light, or CMYK");
}

void require_albedo(const fs::path& path, const algebra::Grid<float>& map) {
  const auto values = map.values();
  const auto sound = [](float v) { return v >= 0 && v <= std::numeric_limits<float>::max(); };
  bool all_sound = true;
  for (const float v : values) all_sound &= sound(v);
  if (all_sound) return;
  const auto wrong = std::find_if_not(values.begin(), values.end(), sound);
  const auto at = static_cast<std::size_t>(wrong - values.begin());
  throw cannot_read(path, fmt::format("albedo at row {}, column {} = {:g}, allowed 0 or more",
                                      at / map.columns(), at % map.columns(), *wrong));
}

}  // namespace

Image read_image(const fs::path& path) {
  const auto input = opened(path);
  const auto& spec = input->spec();
  return within_memory(path, spec, [&] {
    Image image(static_cast<std::size_t>(spec.width), static_cast<std::size_t>(spec.height),
                spec.channelnames);
    for_all_rows<float>(*input, path, [&](const RowsRead<float>& band) {
      const auto start = band.first_row * image.width * image.channels.size();
      std::copy(band.values.begin(), band.values.end(),
                image.values.begin() + static_cast<std::ptrdiff_t>(start));
    });
    return image;
  });
}

Image read_light(const fs::path& path, Coding coding) {
  const auto input = opened(path);
  const auto& spec = input->spec();
  require_light(path, spec);
  const auto curve = curve_of(spec, coding);
  const auto [r, g, b] = rgb_channels(spec);
  const auto stride = static_cast<std::size_t>(spec.nchannels);
  return within_memory(path, spec, [&, r = r, g = g, b = b] {
    Image image(static_cast<std::size_t>(spec.width), static_cast<std::size_t>(spec.height),
                {"R", "G", "B"});
    for_all_rows<float>(*input, path, [&](const RowsRead<float>& band) {
      float* light = image.values.data() + 3 * band.first_row * image.width;
      for (std::size_t i = 0; i < band.values.size(); i += stride)
        for (const std::size_t k : {r, g, b}) *light++ = linear(band.values[i + k], curve);
    });
    for (const float value : image.values)
      if (!std::isfinite(value)) throw cannot_read(path, "light that is not finite");
    return image;
  });
}

std::optional<std::string> read_attribute(const fs::path& path, std::string_view name) {
  return read_attributes(path, {&name, 1}).front();
}

std::vector<std::optional<std::string>> read_attributes(const fs::path& path,
                                                        std::span<const std::string_view> names) {
  const auto input = opened(path);
  std::vector<std::optional<std::string>> values;
  for (const auto name : names) {
    const auto* found = input->spec().find_attribute(oiio_name(name));
    values.push_back(found ? std::optional(found->get_string()) : std::nullopt);
  }
  return values;
}

void require_albedo_map(const fs::path& path, double exponent) {
  algebra::require_within("albedo exponent", exponent, 0.1, 10);
  const auto input = opened(path);
  require_two_to_one(path, input->spec());
  require_light(path, input->spec());
}

algebra::Grid<float> read_albedo_map(const fs::path& path, Coding coding, double exponent) {
  algebra::require_within("albedo exponent", exponent, 0.1, 10);
  const auto input = opened(path);
  const auto& spec = input->spec();
  require_two_to_one(path, spec);
  require_light(path, spec);
  const FloatingTone tone{curve_of(spec, coding), static_cast<float>(exponent)};
  return within_memory(path, spec, [&] {
    algebra::Grid<float> map(static_cast<std::size_t>(spec.height),
                             static_cast<std::size_t>(spec.width));
    if (spec.format == OIIO::TypeDesc::UINT8)
      read_luminance(*input, path, ByteTone(tone), map);
    else
      read_luminance(*input, path, tone, map);
    require_albedo(path, map);
    return map;
  });
}

}  // namespace coppermoon::texture
