// SPDX-License-Identifier: MIT
#include "uses/picture/development.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>

#include "algebra/error.h"
#include "colour/display.h"
#include "texture/contact_sheet.h"
#include "texture/write_image.h"
#include "uses/picture/camera_request.h"
#include "uses/picture/caption.h"
#include "uses/picture/disc_outline.h"
#include "uses/picture/picture_files.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

constexpr const char *usual_display = "sRGB", *high_range_display = "Rec.2100-PQ";

const PictureFile& file_of(const std::filesystem::path& picture) {
  return files::format_of(picture, picture_files(), "a picture");
}

/// Adapts development settings to a picture's file format. For high dynamic range, Rec.2100-PQ replaces the default
/// display. View and display names are then spelt as in the OpenColorIO configuration, which may come from $OCIO.
Development for_file(Development development, const std::filesystem::path& picture) {
  if (file_of(picture).high_range && development.display == usual_display)
    development.display = high_range_display;
  const auto config = colour::config_for(development.view, development.display, development.config);
  development.config = config.string();
  development.display = colour::display_named(development.display, config);
  development.view = colour::view_named(development.view, development.display, config);
  return development;
}

/// Function that returns the level of a colour: its luminance, or its brightest channel [cd/m²].
using Level = double(colour::WorkingSpace, std::span<const double>);

/// Levels [cd/m²] of all lit pixels that the Moon covers wholly or partly.
std::vector<double> levels(Level level, const texture::Image& frame, colour::WorkingSpace space,
                           const std::optional<DiscOutline>& disc) {
  std::vector<double> lit;
  require_colours(frame);
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      const std::array<double, 3> pixel{frame(r, c, 0), frame(r, c, 1), frame(r, c, 2)};
      if (pixel == std::array{0., 0., 0.}) continue;
      const double y = level(space, pixel);
      if (y > 0 && (!disc || covered_share(*disc, static_cast<double>(c) + 0.5,
                                           static_cast<double>(r) + 0.5) > 0))
        lit.push_back(y);
    }
  return lit;
}

/// 99th percentile of the levels of lit pixels.
double bright_level_of(std::vector<double> lit) {
  const auto bright = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() * 99 / 100);
  std::nth_element(lit.begin(), bright, lit.end());
  return *bright;
}

/// Finds the 99th percentile of the numbers that are added to it. Only the greatest are kept, as many as are needed.
class Brightest {
 public:
  explicit Brightest(std::size_t most) : kept_(most - most * 99 / 100) {}

  void add(double level) {
    greatest_.push_back(level);
    ++count_;
    if (greatest_.size() <= 2 * kept_) return;
    std::ranges::nth_element(greatest_, greatest_.begin() + std::ptrdiff_t(kept_), std::greater{});
    greatest_.resize(kept_);
  }

  std::size_t count() const { return count_; }

  double percentile() {
    const auto bright = greatest_.begin() + std::ptrdiff_t(count_ - 1 - count_ * 99 / 100);
    std::ranges::nth_element(greatest_, bright, std::greater{});
    return *bright;
  }

 private:
  std::size_t kept_, count_ = 0;
  std::vector<double> greatest_;
};

/// Calls a function with each band of rows of a texture, from top to bottom.
void for_each_band(const LitTexture& texture,
                   const std::function<void(const texture::Image&)>& act) {
  constexpr std::size_t rows_at_once = 64;
  const auto& [width, height, channels] = texture.layout;
  for (std::size_t row = 0; row < height; row += rows_at_once) {
    texture::Image band(width, std::min(rows_at_once, height - row), channels);
    texture.rows(row, band.values);
    act(band);
  }
}

/// Number of trailing bits that are dropped from a level. Levels (floats) with equal leading bits are counted together.
constexpr unsigned dropped_bits = 12;

std::size_t step_of(double level) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(level)) >> dropped_bits;
}

double middle_of(std::size_t step) {
  const auto half = std::uint32_t{1} << (dropped_bits - 1);
  return std::bit_cast<float>((static_cast<std::uint32_t>(step) << dropped_bits) | half);
}

std::optional<colour::Camera> camera_of(const Development& development) {
  return camera_of(development.camera, development.f_number, development.focal_length_mm);
}

double f_number_of(const Development& development) {
  const auto camera = camera_of(development);
  return camera ? camera->optics.focal_length_mm / camera->optics.aperture_mm
                : development.f_number.value_or(12.1);
}

/// Cube of the mean cube root of the pixels' brightest channels. It changes smoothly as the shadow covers the disc.
double cubic_mean(const LitSums& sums) {
  const double mean = sums.cube_roots / static_cast<double>(sums.count);
  return mean * mean * mean;
}

/// Mean weighted by the cube of each value. It is close to the mean of the disc's bright part, however small that is.
double bright_mean(const LitSums& sums) { return sums.fourth_powers / sums.cubes; }

/// Harmonic mean. It is close to the mean of the disc's dark part once that part is a tenth of the disc.
double dark_mean(const LitSums& sums) { return static_cast<double>(sums.count) / sums.inverses; }

/// An exposure of one second with the f-number and ISO speed of the development.
colour::Exposure one_second(const Development& development) {
  return {1, f_number_of(development), development.iso};
}

/// Share of saturation to which a sky is exposed. The night sky comes out dark. Brighter skies come out brighter, as
/// they look to the adapted eye, but never near white.
///
/// Source  Krawczyk, Myszkowski & Seidel (2005), Perceptual effects in real-time tone mapping, Proc. SCCG, eq. 11: a
///         scene's key as a function of its luminance
double sky_level(double sky_cd_m2) {
  constexpr double least = 0.1, most = 0.4;  // below 0.1, a dim Moon would be lost in the dark
  return std::clamp(1.03 - 2 / (2 + std::log10(sky_cd_m2 + 1)), least, most);
}

/// Exposure time [s] that brings the brightest channel to `level`, or the sky to sky_level if that is sooner.
double time_for(const Development& development, double sky_cd_m2,
                const std::optional<double>& brightest = {}, double level = 0) {
  double scale = brightest ? level / *brightest : std::numeric_limits<double>::max();
  if (sky_cd_m2 > 0) scale = std::min(scale, sky_level(sky_cd_m2) / sky_cd_m2);
  return std::clamp(scale / scale_of(development, one_second(development)), 1e-6, 1e5);
}

/// Shares of saturation that the exposure rules aim at.
constexpr double brightest_level = 0.8, followed_level = 0.25, composite_level = 0.6;

/// Computes exposures by the rule that a development sets.
///
/// Given  lit     number of lit pixels
///        sums    computes the sums over the lit pixels
///        bright  computes the 99th percentile of the lit pixels' brightest channels
template <class Sums, class Bright>
Exposures exposed_for(const Development& development, double sky_cd_m2, std::size_t lit,
                      const Sums& sums, const Bright& bright) {
  using enum ExposureTime::Rule;
  Exposures all{one_second(development)};
  const auto rule = development.time.rule;
  auto& time_s = all.shorter.time_s;
  const auto time = [&](double brightest, double level) {
    return time_for(development, sky_cd_m2, brightest, level);
  };
  if (rule == fixed) {
    time_s = development.time.seconds;
  } else if (lit == 0) {
    if (sky_cd_m2 > 0) time_s = time_for(development, sky_cd_m2);
  } else if (rule == automatic) {
    time_s = time(bright(), brightest_level);
  } else if (rule == follow) {
    time_s = time(cubic_mean(sums()), followed_level);
  } else {
    const LitSums of_all = sums();
    time_s = time(bright_mean(of_all), composite_level);
    all.longer_s = std::max(time_s, time(dark_mean(of_all), composite_level));
  }
  return all;
}

void require_ending(const std::filesystem::path& file, const char* what, const char* ending) {
  if (!file.empty() && file.extension() != ending)
    throw algebra::Error(fmt::format("{}: {} ends in {}", file.string(), what, ending));
}

void write_files(const CameraRequest& request, const colour::Camera& camera,
                 const colour::Photograph& photograph, const colour::Exposure& exposure,
                 texture::Attributes attributes) {
  add_exposure(attributes, {exposure});
  if (!request.raw.empty())
    write_raw(request.raw, request, camera, exposure.iso, photograph, attributes);
  attributes["coppermoon:saturation_cd_m2"] = static_cast<float>(photograph.saturation_cd_m2);
  if (!request.photograph.empty())
    texture::write_exr(request.photograph, image_of(photograph.scene_linear, photograph.valid),
                       attributes, {.type = texture::ExrType::floating, .allow_negative = true});
}

/// The camera's photograph of a frame, in the frame's unit of light; if there is no camera, the frame itself.
colour::Image taken(const Development& development, const colour::Exposure& exposure,
                    const Frame& frame) {
  const auto camera = camera_of(development);
  if (!camera) return pixels_of(frame.light);
  const auto photograph = photographed(development.camera, *camera, frame, exposure);
  write_files(development.camera, *camera, photograph, exposure, frame.attributes);
  return photograph.scene_linear;
}

/// The factor (1 - exp(-x)) / x, which dims light x to 1 - exp(-x).
double rounded_off(double x) { return std::abs(x) < 1e-9 ? 1 : -std::expm1(-x) / x; }

/// Dims each pixel so that its brightest channel x, in units of saturation, becomes 1 - exp(-x). Colours do not change.
texture::Image dimmed(texture::Image light, colour::WorkingSpace space, double scale) {
  require_colours(light);
  for (std::size_t r = 0; r < light.height; ++r)
    for (std::size_t c = 0; c < light.width; ++c) {
      const double y = colour::brightest_channel(
          space, std::array<double, 3>{light(r, c, 0), light(r, c, 1), light(r, c, 2)});
      const double share = rounded_off(scale * std::max(0., y));
      for (std::size_t k = 0; k < 3; ++k)
        light(r, c, k) = static_cast<float>(light(r, c, k) * share);
    }
  return light;
}

/// The longer exposure of a composite, in units of saturation.
colour::Image shadow_taken(const Development& development, const colour::Exposure& exposure,
                           const Frame& frame) {
  constexpr auto other_noise = std::uint64_t{1} << 63;
  const bool through_camera = camera_of(development).has_value();
  const double scale = scale_of(development, exposure);
  const LimbPixels limb(through_camera ? frame.seen.disc : std::nullopt, frame.light,
                        frame.seen.sky_cd_m2 > 0);
  const auto covered = limb.covered(dimmed(limb.with_ground(frame.light), frame.space, scale));
  auto seen = frame.seen;
  seen.sky_cd_m2 *= rounded_off(scale * seen.sky_cd_m2);
  auto shadow = taken(development, exposure,
                      {covered, frame.space, seen, frame.number ^ other_noise, frame.attributes});
  for (auto& pixel : shadow.values())
    for (float& value : pixel) value = static_cast<float>(scale * value);
  return shadow;
}

/// Composite of two exposures, in units of saturation.
colour::Image composite(const Development& development, const Exposures& exposures,
                        const Frame& frame) {
  constexpr double share = 0.3;  // weight of the longer exposure
  auto longer = exposures.shorter;
  longer.time_s = *exposures.longer_s;
  auto all = taken(development, exposures.shorter, frame);
  const auto shadow = shadow_taken(development, longer, frame);
  const double scale = scale_of(development, exposures.shorter);
  for (std::size_t i = 0; i < all.values().size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      float& value = all.values()[i][c];
      value = static_cast<float>((1 - share) * scale * value + share * shadow.values()[i][c]);
    }
  return all;
}

colour::DisplayTransform transform_of(const Development& development, double scale) {
  const auto config = colour::config_for(development.view, development.display, development.config);
  return {scale, development.view, development.display, config, development.config_space};
}

/// Scales light and transforms it into a picture for a display, with numbers clamped to the range 0 to 1.
texture::Image shown_of(const Development& development, double scale, colour::Image scene,
                        colour::WorkingSpace space) {
  auto image =
      image_of(colour::developed(std::move(scene), space, transform_of(development, scale)));
  for (float& value : image.values) value = std::clamp(value, 0.F, 1.F);
  return image;
}

/// Writes a picture whose header states how it was developed.
void write_shown(const std::filesystem::path& file, const Development& development,
                 const Exposures& exposures, ShownPicture picture) {
  picture.bits = development.bits;
  picture.attributes["coppermoon:view"] = development.display + ", " + development.view;
  add_exposure(picture.attributes, exposures);
  file_of(file).write(file, picture);
}

}  // namespace

void LitSums::add(double brightest_cd_m2) {
  const double cube = brightest_cd_m2 * brightest_cd_m2 * brightest_cd_m2;
  ++count;
  inverses += 1 / brightest_cd_m2;
  cube_roots += std::cbrt(brightest_cd_m2);
  cubes += cube;
  fourth_powers += cube * brightest_cd_m2;
}

Exposures exposures_for(const Development& development, const texture::Image& frame,
                        colour::WorkingSpace space, const SeenFrame& seen) {
  const auto lit = development.time.rule == ExposureTime::Rule::fixed
                       ? std::vector<double>{}
                       : levels(colour::brightest_channel, frame, space, seen.disc);
  const auto sums = [&] {
    LitSums all;
    for (const double y : lit) all.add(y);
    return all;
  };
  return exposed_for(development, seen.sky_cd_m2, lit.size(), sums,
                     [&] { return bright_level_of(lit); });
}

Exposures exposures_for(const Development& development, const LitTexture& texture) {
  const auto rule = development.time.rule;
  Brightest brightest(texture.layout.width * texture.layout.height);
  LitSums sums;
  if (rule != ExposureTime::Rule::fixed)
    for_each_band(texture, [&](const texture::Image& band) {
      for (const double y : levels(colour::brightest_channel, band, texture.space, {}))
        rule == ExposureTime::Rule::automatic ? brightest.add(y) : sums.add(y);
    });
  return exposed_for(
      development, 0, brightest.count() + sums.count, [&] { return sums; },
      [&] { return brightest.percentile(); });
}

double sky_over_moon(const texture::Image& frame, colour::WorkingSpace space,
                     const SeenFrame& seen) {
  const double sky = seen.sky_cd_m2;
  if (sky == 0) return 0;
  const auto lit = levels(colour::luminance, frame, space, seen.disc);
  // half floats cannot resolve a Moon that adds only a thousandth to the sky's light
  return lit.empty() ? 0 : sky / std::max(bright_level_of(lit) - sky, sky / 1000);
}

SharedExposure::SharedExposure(const Development& development) : development_(development) {
  if (development.time.rule == ExposureTime::Rule::automatic)
    counts_.resize(std::size_t{1} << (32 - dropped_bits));
}

void SharedExposure::add(const texture::Image& frame, colour::WorkingSpace space,
                         const SeenFrame& seen) {
  if (development_.time.rule == ExposureTime::Rule::fixed) return;
  const auto lit = levels(colour::brightest_channel, frame, space, seen.disc);
  sky_cd_m2_ = std::max(sky_cd_m2_, seen.sky_cd_m2);
  for (const double y : lit) {
    sums_.add(y);
    if (!counts_.empty()) ++counts_[step_of(y)];
  }
}

Exposures SharedExposure::exposures() const {
  const auto bright = [&] {
    std::size_t step = 0;
    for (std::size_t below = counts_[0]; below <= sums_.count * 99 / 100;) below += counts_[++step];
    return middle_of(step);
  };
  return exposed_for(
      development_, sky_cd_m2_, sums_.count, [&] { return sums_; }, bright);
}

double scale_of(const Development& development, const colour::Exposure& exposure) {
  const auto camera = camera_of(development);
  return camera ? 1 / colour::saturation_cd_m2(*camera, exposure)
                : colour::exposure_scale(exposure);
}

bool is_a_cameras(const Development& development, const SeenFrame& seen) {
  return !seen.of_another_program || development.time.rule == ExposureTime::Rule::fixed ||
         development.f_number || !development.camera.model.empty();
}

void add_exposure(texture::Attributes& attributes, const Exposures& exposures) {
  const auto& [exposure, longer_s, a_cameras] = exposures;
  if (!a_cameras) return;
  attributes["expTime"] = static_cast<float>(exposure.time_s);
  attributes["aperture"] = static_cast<float>(exposure.f_number);
  attributes["isoSpeed"] = static_cast<float>(exposure.iso);
  if (longer_s) attributes["coppermoon:longer_exposure_s"] = static_cast<float>(*longer_s);
}

Development of_high_range(Development development) {
  development.display = high_range_display;
  development.bits = 16;
  return development;
}

void require_sound(const Development& asked, const std::filesystem::path& picture) {
  const auto development = for_file(asked, picture);
  if (file_of(picture).high_range && development.display != high_range_display)
    throw algebra::Error(fmt::format("display = {}, allowed for a picture that ends in {} {}",
                                     development.display, file_of(picture).ending,
                                     high_range_display));
  if (!development.config_space.empty() && development.config.empty())
    throw algebra::Error(
        fmt::format("config-space = {}, allowed with a config", development.config_space));
  if (development.caption) texture::sheet_font();
  require_ending(development.camera.photograph, "a photograph", ".exr");
  if (development.time.rule == ExposureTime::Rule::composite &&
      !(development.camera.raw.empty() && development.camera.photograph.empty()))
    throw algebra::Error(
        "exposure time = composite, allowed one exposure for a raw file or a photograph: auto, "
        "follow or seconds");
  colour::exposure_scale({development.time.seconds, f_number_of(development), development.iso});
  if (const auto camera = camera_of(development)) {
    colour::gain_at(*camera, development.iso);
    if (!development.camera.raw.empty()) require_raw_file(development.camera.raw, *camera);
  }
}

std::string fingerprint(const Development& development, colour::WorkingSpace space) {
  return colour::fingerprint(space, transform_of(development, 1));
}

texture::Image shown(const Development& development, double scale, const texture::Image& frame,
                     colour::WorkingSpace space) {
  return shown_of(development, scale, pixels_of(frame), space);
}

texture::Image developed(const Development& development, const Exposures& exposures,
                         const Frame& frame) {
  const auto& [exposure, longer_s, a_cameras] = exposures;
  const bool through_camera = camera_of(development).has_value();  // a camera blurs the Moon's edge
  const LimbPixels limb(through_camera ? std::nullopt : frame.seen.disc, frame.light,
                        frame.seen.sky_cd_m2 > 0);
  const auto light = limb.with_ground(frame.light);
  const Frame whole{light, frame.space, frame.seen, frame.number, frame.attributes};
  auto picture =
      longer_s ? shown_of(development, 1, composite(development, exposures, whole), frame.space)
               : shown_of(development, scale_of(development, exposure),
                          taken(development, exposure, whole), frame.space);
  limb.cover(picture, development.display == high_range_display);
  return picture;
}

void write_picture(const Development& asked, const Exposures& exposures, const Frame& frame,
                   texture::Attributes attributes, const std::filesystem::path& picture) {
  const auto development = for_file(asked, picture);
  auto image = developed(development, exposures, frame);
  if (development.caption) {
    const auto [left, right] = caption_of(frame.attributes);
    const float grey = development.display == high_range_display ? 0.5F : 0.8F;  // 0.5 is 100 cd/m²
    texture::write_captions(image, left, right, grey, texture::sheet_font());
  }
  if (const auto date = frame.attributes.find("capDate"); date != frame.attributes.end())
    attributes["capDate"] = date->second;
  write_shown(picture, development, exposures,
              {{image.width, image.height, image.channels},
               texture::rows_of(image),
               {},
               std::move(attributes)});
}

texture::Rows developed_rows(const Development& development, const Exposures& exposures,
                             const LitTexture& texture) {
  return [development, exposures, texture](std::size_t row, std::span<float> values) {
    const auto& [width, height, channels] = texture.layout;
    texture::Image light(width, values.size() / (3 * width), channels);
    texture.rows(row, light.values);
    std::ranges::copy(developed(development, exposures, {light, texture.space}).values,
                      values.begin());
  };
}

void write_picture(const Development& asked, const Exposures& exposures, const LitTexture& texture,
                   const texture::Attributes& attributes, const std::filesystem::path& picture) {
  const auto development = for_file(asked, picture);
  write_shown(picture, development, exposures,
              {{texture.layout.width, texture.layout.height, {"R", "G", "B"}},
               developed_rows(development, exposures, texture),
               {},
               attributes});
}

}  // namespace coppermoon::uses
