// SPDX-License-Identifier: MIT
#include "texture/read_image.h"

#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "algebra/error.h"
#include "texture/openimageio/how_stored.h"
#include "texture/openimageio/image_input.h"
#include "texture/openimageio/oiio_attributes.h"
#include "texture/openimageio/raw_input.h"
#include "texture/openimageio/silence.h"

namespace coppermoon::texture {
namespace {

namespace fs = std::filesystem;
/// Calls a function, and if it runs out of memory, throws an Error that names the file.
template <class Make>
auto within_memory(const fs::path& path, const OIIO::ImageSpec& spec, Make make) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  }
  throw cannot_read(path, fmt::format("no memory for {} x {} texels", spec.width, spec.height));
}

/// The curve that turns a file's numbers into linear light: a power, or sRGB's curve.
struct Curve {
  bool srgb;
  float power;
  bool white_is_zero = false;
};

Curve curve_of(const OIIO::ImageSpec& spec, Coding coding, bool white_is_zero) {
  const std::string says = spec.get_string_attribute("oiio:ColorSpace");
  if (coding == Coding::srgb || coding == Coding::camera) return {true, 1, white_is_zero};
  if (coding == Coding::linear || says == "linear" || says == "Linear")
    return {false, 1, white_is_zero};
  if (says.starts_with("Gamma"))
    return {false, spec.get_float_attribute("oiio:Gamma", 2.2F), white_is_zero};
  return {says == "sRGB" || !spec.format.is_floating_point(), 1, white_is_zero};
}

float linear(float v, Curve curve) {
  if (curve.white_is_zero) v = 1 - v;
  if (curve.srgb) return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
  return curve.power == 1 ? v : std::pow(v, curve.power);
}

/// Names of a file's channels. OpenImageIO 2.5 would call luminance and the two colour differences R, G and B.
std::vector<std::string> channels_of(const OIIO::ImageSpec& spec) {
  if (spec.get_int_attribute("openexr:luminancechroma") != 0) return {"Y", "RY", "BY"};
  return spec.channelnames;
}

/// A list of channels for an error message, shortened if there are more than 12.
std::string names_of(const std::vector<std::string>& channels) {
  constexpr std::size_t most = 12;
  const auto shown = static_cast<std::ptrdiff_t>(std::min(most, channels.size()));
  return fmt::format("channels {}{}", fmt::join(channels.begin(), channels.begin() + shown, ", "),
                     channels.size() > most ? ", …" : "");
}

/// Refuses bands other than grey, or red, green and blue, except in OpenEXR. Alpha may follow; after grey, a second
/// band counts as alpha. A colour TIFF may have more bands, because its header says that the first three are colours.
void require_bands(const fs::path& path, const OIIO::ImageSpec& spec) {
  constexpr int colours = 2;
  const int bands = spec.nchannels - (spec.alpha_channel >= 0 ? 1 : 0);
  if (bands <= 3 || spec.get_int_attribute("tiff:PhotometricInterpretation") == colours) return;
  throw cannot_read(
      path,
      fmt::format("{} bands, and nothing says which of them are colours, allowed up to 3", bands));
}

/// Indices of the red, green and blue channels; all three are the same for grey. In OpenEXR the channels' names decide,
/// in other formats their order.
std::array<std::size_t, 3> rgb_channels(const fs::path& path, const OIIO::ImageInput& input) {
  const auto& spec = input.spec();
  if (!is_openexr(input)) require_bands(path, spec);
  const auto channels = channels_of(spec);
  const auto at = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(channels, name) - channels.begin());
  };
  const auto has = [&](const char* name) { return at(name) < channels.size(); };
  if (has("R") && has("G") && has("B")) return {at("R"), at("G"), at("B")};
  if (has("Y") && !has("RY") && !has("BY") && !has("X") && !has("Z"))
    return {at("Y"), at("Y"), at("Y")};
  if (!is_openexr(input))
    return spec.nchannels < 3 ? std::array<std::size_t, 3>{0, 0, 0}
                              : std::array<std::size_t, 3>{0, 1, 2};
  throw cannot_read(path, names_of(channels) + ", allowed R, G and B, or Y alone");
}

/// Reads the texels within an image's display window, several rows at a time. Calls `put` with each texel's index in
/// the picture and with its values. Places for which the file has no texels are skipped.
template <class Put>
void for_all_texels(OIIO::ImageInput& input, const fs::path& path, const Put& put) {
  const auto windows = windows_of(input);
  const auto &data = windows.data, &display = windows.display;
  const auto stride = static_cast<std::ptrdiff_t>(input.spec().nchannels);
  const auto top = data.top - display.top, left = std::max(data.left, display.left),
             right = std::min(data.left + static_cast<int>(data.width),
                              display.left + static_cast<int>(display.width));
  for_all_rows<float>(input, path, [&](const RowsRead<float>& band) {
    tbb::parallel_for(std::size_t{0}, band.rows, [&](std::size_t r) {
      const auto row = top + static_cast<std::ptrdiff_t>(band.first_row + r);
      if (row < 0 || row >= static_cast<std::ptrdiff_t>(display.height)) return;
      const float* texels = band.values.data() + r * data.width * static_cast<std::size_t>(stride);
      for (auto x = left; x < right; ++x)
        put(static_cast<std::size_t>(row) * display.width +
                static_cast<std::size_t>(x - display.left),
            texels + (x - data.left) * stride);
    });
  });
}

/// A black image that is as large as the picture in the file.
Image black(const OIIO::ImageInput& input, std::vector<std::string> channels) {
  const auto shown = windows_of(input).display;
  return {shown.width, shown.height, std::move(channels)};
}

float luminance(float red, float green, float blue) {
  return 0.2126F * red + 0.7152F * green + 0.0722F * blue;
}

/// Converts coded numbers to linear light with a tone curve, and colours to luminance.
struct FloatingTone {
  using Number = float;
  Curve curve;

  float grey(float v) const { return linear(v, curve); }
  float coloured(float r, float g, float b) const {
    return luminance(linear(r, curve), linear(g, curve), linear(b, curve));
  }
};

/// Converts 8-bit numbers as FloatingTone does, but with a table of the light for all 256 values.
struct ByteTone {
  using Number = std::uint8_t;
  explicit ByteTone(const FloatingTone& of) {
    for (std::size_t i = 0; i < light.size(); ++i)
      light[i] = of.grey(static_cast<float>(i) / 255.0F);
  }
  float grey(std::uint8_t v) const { return light[v]; }
  float coloured(std::uint8_t r, std::uint8_t g, std::uint8_t b) const {
    if (r == g && g == b) return light[r];
    return luminance(light[r], light[g], light[b]);
  }

  std::array<float, 256> light{};
};

/// Converts coded numbers to luminance with the file's own colour profile.
struct ProfiledTone {
  using Number = float;
  const ColourProfile& profile;

  float grey(float v) const { return light(&v); }
  float coloured(float r, float g, float b) const {
    const std::array<float, 3> coded{r, g, b};
    return light(coded.data());
  }
  float light(const float* coded) const {
    std::array<float, 3> rgb{};
    profile.light(coded, rgb.data(), 1);
    return luminance(rgb[0], rgb[1], rgb[2]);
  }
};

/// Finds texels of a map that show no ground, being fully transparent or having GDAL's number for missing data.
template <class Number>
struct Holes {
  int alpha;
  std::optional<Number> no_data;

  Holes(const OIIO::ImageSpec& spec, const Storage& storage) : alpha(spec.alpha_channel) {
    const bool whole = !spec.format.is_floating_point();
    const double most = whole ? std::exp2(8 * static_cast<double>(spec.format.size()) -
                                          (spec.format.is_signed() ? 1 : 0)) -
                                    1
                              : 1;
    if (storage.no_data)
      no_data = std::is_floating_point_v<Number> ? static_cast<Number>(*storage.no_data / most)
                                                 : static_cast<Number>(*storage.no_data);
  }

  const char* at(const Number* texel, std::size_t channel) const {
    if (alpha >= 0 && texel[alpha] <= 0) return "is transparent";
    return no_data && is_near(texel[channel], *no_data) ? "has no data (GDAL_NODATA)" : nullptr;
  }

  /// Whether two numbers are equal, apart from the rounding of one that was written as text.
  static bool is_near(Number a, Number b) {
    if constexpr (std::is_floating_point_v<Number>)
      return std::abs(a - b) <= static_cast<Number>(1e-6) * std::abs(b);
    else
      return a == b;
  }
};

template <class Tone>
void read_luminance(OIIO::ImageInput& input, const fs::path& path, const Tone& tone,
                    const Storage& storage, algebra::Grid<float>& map) {
  const auto rgb = rgb_channels(path, input);
  const auto r = rgb[0], g = rgb[1], b = rgb[2];
  const auto stride = static_cast<std::size_t>(input.spec().nchannels);
  const Holes<typename Tone::Number> holes(input.spec(), storage);
  const auto add = [&](const auto& band) {
    tbb::parallel_for(std::size_t{0}, band.rows, [&](std::size_t row) {
      const auto* texel = band.values.data() + row * map.columns() * stride;
      for (float& value : map.row(band.first_row + row)) {
        if (const auto* why = holes.at(texel, r))
          throw cannot_read(path, fmt::format("the albedo map {} at row {}, allowed ground "
                                              "everywhere",
                                              why, band.first_row + row));
        value = r == g ? tone.grey(texel[r]) : tone.coloured(texel[r], texel[g], texel[b]);
        texel += stride;
      }
    });
  };
  for_all_rows<typename Tone::Number>(input, path, add);
}

void require_two_to_one(const fs::path& path, const OIIO::ImageInput& input,
                        const Storage& storage) {
  const auto& spec = input.spec();
  const auto [data, display] = windows_of(input);
  if (is_raw(input)) throw cannot_read(path, "albedo map in a raw file, allowed other images");
  const auto [width, height] = storage.on_its_side() ? std::pair(spec.height, spec.width)
                                                     : std::pair(spec.width, spec.height);
  if (width != 2 * height)
    throw cannot_read(path,
                      fmt::format("albedo map of {} x {} texels, allowed 2:1", width, height));
  if (spec.full_width != spec.width || spec.full_height != spec.height || data != display)
    throw cannot_read(path,
                      fmt::format("albedo map cropped from {} x {} texels, allowed whole ones",
                                  spec.full_width, spec.full_height));
}

/// Refuses inks other than cyan, magenta, yellow and black, because OpenImageIO cannot convert them to light.
void require_light(const fs::path& path, const OIIO::ImageSpec& spec) {
  if (spec.channelnames[0].starts_with("ink"))
    throw cannot_read(path, "channels of inks, allowed grey, colours of light, or CMYK");
}

/// Prefix, such as "ViewLayer.Combined.", of the channels in the only layer that has all the given names. It is empty
/// if the first name exists without a prefix, or if no layer or several layers have all names.
std::string only_layer_of(const std::vector<std::string>& channels,
                          const std::vector<std::string>& names) {
  const auto has = [&](const std::string& name) {
    return std::ranges::find(channels, name) != channels.end();
  };
  std::vector<std::string> layers;
  for (const auto& channel : channels) {
    const auto layer = channel.substr(0, channel.rfind('.') + 1);
    if (channel == layer + names.front() &&
        std::ranges::all_of(names, [&](const auto& name) { return has(layer + name); }))
      layers.push_back(layer);
  }
  return layers.size() == 1 && !has(names.front()) ? layers.front() : "";
}

/// Refuses a map in which a few texels outshine all others, because scaling by the map's mean would then darken the
/// rest. The excess of the brightest 0.1 % of texels over the 99.9th percentile may be at most 1 % of all light.
void require_no_rogues(const fs::path& path, const algebra::Grid<float>& map) {
  constexpr double share = 0.001, most_light = 0.01;
  const auto values = map.values();
  const auto all = static_cast<double>(values.size());
  double light = 0;
  for (const float v : values) light += double{v};
  const auto greatest = std::ranges::max_element(values);
  if (double{*greatest} * all * share <= most_light * light)
    return;  // the usual case; no sorted copy is needed
  std::vector<float> sorted(values.begin(), values.end());
  const auto percentile = sorted.begin() + static_cast<std::ptrdiff_t>((1 - share) * (all - 1));
  std::ranges::nth_element(sorted, percentile);
  double beyond = 0;
  for (auto v = percentile; v != sorted.end(); ++v) beyond += double{*v} - double{*percentile};
  if (beyond <= most_light * light) return;
  const auto at = static_cast<std::size_t>(greatest - values.begin());
  throw cannot_read(path, fmt::format("albedo at row {}, column {} = {:g}, and 99.9 % of the map "
                                      "is at most {:g}: the few beyond it "
                                      "give {:.0f} % of its light, allowed 1 %",
                                      at / map.columns(), at % map.columns(), *greatest,
                                      *percentile, 100 * beyond / light));
}

void require_albedo(const fs::path& path, const algebra::Grid<float>& map) {
  const auto values = map.values();
  const auto sound = [](float v) { return v >= 0 && v <= std::numeric_limits<float>::max(); };
  bool all_sound = true;
  for (const float v : values) all_sound &= sound(v);
  if (all_sound) return require_no_rogues(path, map);
  const auto wrong = std::find_if_not(values.begin(), values.end(), sound);
  const auto at = static_cast<std::size_t>(wrong - values.begin());
  throw cannot_read(path, fmt::format("albedo at row {}, column {} = {:g}, allowed 0 or more",
                                      at / map.columns(), at % map.columns(), *wrong));
}

}  // namespace

Image read_image(const fs::path& path) {
  const Silence silence(path);
  const auto input = opened(path);
  return within_memory(path, input->spec(), [&] {
    auto image = black(*input, input->spec().channelnames);
    const auto stride = image.channels.size();
    for_all_texels(*input, path, [&](std::size_t place, const float* texel) {
      std::copy_n(texel, stride, image.values.data() + stride * place);
    });
    return image;
  });
}

Image read_channels(const fs::path& path, const std::vector<std::string>& names) {
  const Silence silence(path);
  const auto input = opened(path);
  const auto& spec = input->spec();
  if (!spec.format.is_floating_point())
    throw algebra::Error(fmt::format(
        "{}: holds whole numbers, allowed light [cd/m2] in floating-point ones, as an .exr does",
        path.string()));
  const auto channels = channels_of(spec);
  const auto layer = only_layer_of(channels, names);
  std::vector<std::size_t> chosen;
  for (const auto& name : names) {
    const auto found = std::ranges::find(channels, layer + name);
    if (found == channels.end())
      throw algebra::Error(fmt::format("{}: {}, allowed {}", path.string(), names_of(channels),
                                       fmt::join(names, ", ")));
    chosen.push_back(static_cast<std::size_t>(found - channels.begin()));
  }
  return within_memory(path, spec, [&] {
    auto image = black(*input, names);
    for_all_texels(*input, path, [&](std::size_t place, const float* texel) {
      float* value = image.values.data() + names.size() * place;
      for (const auto channel : chosen) *value++ = texel[channel];
    });
    return image;
  });
}

/// Whether the file's own colour profile is used. It is ignored if the user states what the numbers mean.
bool heeds_colours(Coding coding) {
  return coding == Coding::as_file_says || coding == Coding::camera;
}

Image read_light(const fs::path& path, Coding coding,
                 const std::optional<glm::dmat3>& rec709_from_raw) {
  const Silence silence(path);
  const auto input = opened(path);
  const auto& spec = input->spec();
  require_light(path, spec);
  const bool raw = is_raw(*input);
  if (raw && (coding == Coding::srgb || coding == Coding::camera))
    throw cannot_read(
        path, "a raw file coded as sRGB or by a tone curve, allowed as the file says, or linear");
  const auto storage = storage_of(path, *input);
  const auto curve = raw ? Curve{false, 1} : curve_of(spec, coding, storage.white_is_zero);
  const auto* profile = storage.colours && heeds_colours(coding) ? &*storage.colours : nullptr;
  const auto rgb = rgb_channels(path, *input);
  return within_memory(path, spec, [&] {
    auto image = black(*input, {"R", "G", "B"});
    for_all_texels(*input, path, [&](std::size_t place, const float* texel) {
      float* light = image.values.data() + 3 * place;
      const std::array coded{texel[rgb[0]], texel[rgb[1]], texel[rgb[2]]};
      if (profile) return profile->light(coded.data(), light, 1);
      for (const float v : coded) *light++ = linear(v, curve);
    });
    if (raw) make_rec709(path, spec, rec709_from_raw, image);
    tbb::parallel_for(std::size_t{0}, image.height, [&](std::size_t r) {
      const auto row = std::span(image.values).subspan(3 * image.width * r, 3 * image.width);
      if (!std::ranges::all_of(row, [](float value) { return std::isfinite(value); }))
        throw cannot_read(path, "light that is not finite");
    });
    if (storage.orientation == 1) return image;
    Image turned(image.width, image.height, image.channels);
    if (storage.on_its_side()) std::swap(turned.width, turned.height);
    turn_upright(image.values, image.width, image.height, storage.orientation, turned.values);
    return turned;
  });
}

bool is_raw_file(const fs::path& path) {
  const Silence silence(path);
  return is_raw(*opened(path));
}

Windows windows_of(const fs::path& path) {
  const Silence silence(path);
  return windows_of(*opened(path));
}

std::vector<std::optional<std::string>> read_attributes(const fs::path& path,
                                                        std::span<const std::string_view> names) {
  const Silence silence(path);
  const auto input = opened(path);
  std::vector<std::optional<std::string>> values;
  for (const auto name : names) {
    const auto* found = input->spec().find_attribute(oiio_name(name));
    values.push_back(found ? std::optional(found->get_string()) : std::nullopt);
  }
  return values;
}

void require_albedo_map(const fs::path& path) {
  const Silence silence(path);
  const auto input = opened(path);
  require_two_to_one(path, *input, storage_of(path, *input));
  require_light(path, input->spec());
}

algebra::Grid<float> read_albedo_map(const fs::path& path, Coding coding) {
  const Silence silence(path);
  const auto input = opened(path);
  const auto& spec = input->spec();
  const auto storage = storage_of(path, *input);
  require_two_to_one(path, *input, storage);
  require_light(path, spec);
  const FloatingTone tone{curve_of(spec, coding, storage.white_is_zero)};
  return within_memory(path, spec, [&] {
    algebra::Grid<float> map(static_cast<std::size_t>(spec.height),
                             static_cast<std::size_t>(spec.width));
    if (storage.colours && heeds_colours(coding))
      read_luminance(*input, path, ProfiledTone{*storage.colours}, storage, map);
    else if (spec.format == OIIO::TypeDesc::UINT8)
      read_luminance(*input, path, ByteTone(tone), storage, map);
    else
      read_luminance(*input, path, tone, storage, map);
    require_albedo(path, map);
    if (storage.orientation == 1) return map;
    auto turned = storage.on_its_side() ? algebra::Grid<float>(map.columns(), map.rows())
                                        : algebra::Grid<float>(map.rows(), map.columns());
    turn_upright(map.values(), map.columns(), map.rows(), storage.orientation, turned.values());
    return turned;
  });
}

}  // namespace coppermoon::texture
