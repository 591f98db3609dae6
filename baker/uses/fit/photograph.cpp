// SPDX-License-Identifier: MIT
#include "uses/fit/photograph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <numeric>
#include <span>
#include <unordered_set>
#include <vector>

#include "algebra/error.h"
#include "almanac/sky.h"
#include "colour/limb.h"
#include "colour/picture_part.h"
#include "uses/compare/comparison.h"
#include "uses/fit/sky_and_glow.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

using Channel = algebra::Grid<float>;

/// Light above which a channel may be clipped: below all limits of binned.
constexpr float nearly_clipped = 0.84F;

Channel plane_of(const colour::Image& image, std::size_t k) {
  Channel channel(image.rows(), image.columns());
  for (std::size_t i = 0; i < channel.values().size(); ++i)
    channel.values()[i] = image.values()[i][k];
  return channel;
}

/// Light of the sky and of a glow in a channel. Where the sky's noise is cut off at black the sky counts as 0, with an
/// error of what is measured. Where the sky is darker than tone curves are known the glow keeps its prior.
SkyAndGlow light_beside(const AroundTheDisc& light, const AroundTheDisc& black,
                        const AroundTheDisc& glow, const Uncertain& prior, bool linear) {
  constexpr double much = 0.05, of_glow = 0.25, fixed = 1e-9;
  auto found = sky_and_glow(light, glow, linear ? prior : Uncertain{prior.value, fixed});
  if (!linear) found.glow = prior;
  const double black_share =
      std::reduce(black.begin(), black.end()) / static_cast<double>(black.size());
  if (black_share > much) found = {{0, std::max(median_of(light), found.sky.error)}, prior};
  found.glow.error = std::hypot(found.glow.error, of_glow * found.glow.value);
  return found;
}

/// Quantisation step near black of an 8-bit channel, in linear light; 0 of more than 256 values.
double step_of(const texture::Image& photo, std::size_t k) {
  constexpr std::size_t most = 256;
  std::unordered_set<float> values;
  for (std::size_t r = 0; r < photo.height; ++r)
    for (std::size_t c = 0; c < photo.width; ++c)
      if (values.insert(photo(r, c, k)); values.size() > most) return 0;
  return 1 / 12.92 / 255;
}

/// Sums over a bin's pixels.
struct Sum {
  double light = 0, displayed = 0, sunlit = 0, glow = 0, black = 0;
  double squares = 0;        ///< of differences between pixels two apart
  double light_squares = 0;  ///< of the pixels' light
  std::size_t pixels = 0, clipped = 0, pairs = 0;
  ToneSlopes slopes{};  ///< derivatives of the light

  /// Whether few pixels are black or clipped: means over others would be biased.
  bool sound() const {
    constexpr double few = 0.02;
    const auto all = static_cast<double>(pixels);
    return pixels >= 40 && static_cast<double>(clipped) <= 0.005 * all && black <= few * all;
  }
  /// Whether the mean is in the range of tone curves.
  bool bright_enough() const {
    return displayed >= colour::least_displayed * static_cast<double>(pixels);
  }
  double ratio() const { return light / sunlit; }
  double mean() const { return light / static_cast<double>(std::max<std::size_t>(1, pixels)); }
  /// Standard error of the ratio by rounding to steps of light. Where light differs by more than half a step between
  /// pixels, a pixel's error is its own: a mean's is that of a step, times the characteristic function of a normal
  /// distribution. Those of a JPEG's colours are common to a block of it. A camera's own curve is not known to a step
  /// near black: all pixels' errors are then alike.
  double error_of_steps(double step, bool curved) const {
    constexpr double of_a_step = 0.3, two_pi_squared = 2 * std::numbers::pi * std::numbers::pi,
                     block = 256;
    if (step <= 0) return 0;
    const double of_pixel = of_a_step * step / mean() * ratio();
    if (curved) return of_pixel;
    const auto all = static_cast<double>(std::max<std::size_t>(1, pixels));
    const double variance = std::max(0., light_squares / all - mean() * mean());
    return of_pixel * std::hypot(std::exp(-two_pi_squared * variance / (step * step)),
                                 std::sqrt(std::min(1., block / all)));
  }
  /// Standard error of the ratio, from pixels two apart, as light varies across a bin.
  ///
  /// Given  noise_of_means  as colour::noise_of_means
  double error(double noise_of_means) const {
    const double variance = squares / 2 / static_cast<double>(std::max<std::size_t>(1, pairs));
    return std::sqrt(noise_of_means * variance * static_cast<double>(pixels)) / sunlit;
  }
};

/// Channel of a function of each value.
template <class Function>
Channel mapped(Channel channel, const Function& function) {
  for (float& value : channel.values()) value = function(value);
  return channel;
}

float is_black(float value) { return value <= 0 ? 1 : 0; }

/// 1 where any channel is clipped.
Channel clipped_in(const texture::Image& photo, float saturated) {
  Channel clipped(photo.height, photo.width);
  for (std::size_t i = 0; i < clipped.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (photo.values[photo.channels.size() * i + k] >= saturated) clipped.values()[i] = 1;
  return clipped;
}

/// A photograph's channel, resampled to the pixels of the scene.
struct Brought {
  Channel displayed;  ///< by sRGB
  Channel light;      ///< with the tone curve undone
  Channel black;      ///< share of black pixels
  Channel glow;       ///< computed for the usual air
};

/// Adds derivatives of a pixel's light above the sky's by the numbers of a tone curve.
void add_slopes(ToneSlopes& slopes, double light, double displayed, double sky,
                double sky_displayed) {
  const auto of_light = colour::tone_derivatives(displayed),
             of_sky = colour::tone_derivatives(sky_displayed);
  for (std::size_t k = 0; k < slopes.size(); ++k)
    slopes[k] += light * of_light[k] - sky * of_sky[k];
}

/// Light to be subtracted: the sky's, as displayed and as the scene's; a factor on the glow.
struct Off {
  double displayed, sky, glow;
};

std::vector<Sum> sums_of(const FitScene& scene, const Brought& channel, const Channel& clipped,
                         const Off& off, bool curved) {
  const auto& light = channel.light;
  std::vector<Sum> sums(scene.bins);
  const auto subtracted = [&](std::size_t pixel) {
    return off.sky + off.glow * channel.glow.values()[pixel];
  };
  const auto lit = [&](std::size_t pixel) { return light.values()[pixel] - subtracted(pixel); };
  for (const auto& [pixel, ground, sunlit, colour, bin] : scene.grounds) {
    auto& sum = sums[bin];
    ++sum.pixels;
    sum.black += channel.black.values()[pixel];
    if (clipped.values()[pixel] > 1e-3F) {
      ++sum.clipped;
      continue;
    }
    const double of_pixel = lit(pixel);
    sum.light += of_pixel;
    sum.light_squares += of_pixel * of_pixel;
    sum.displayed += channel.displayed.values()[pixel];
    sum.sunlit += sunlit;
    sum.glow += channel.glow.values()[pixel];
    if (curved)
      add_slopes(sum.slopes, light.values()[pixel], channel.displayed.values()[pixel],
                 subtracted(pixel), off.displayed);
  }
  const auto& grounds = scene.grounds;
  for (std::size_t i = 0; i + 2 < grounds.size(); ++i) {
    const auto &one = grounds[i], &other = grounds[i + 2];
    if (other.pixel != one.pixel + 2 || other.bin != one.bin) continue;
    if (clipped.values()[one.pixel] > 1e-3F || clipped.values()[other.pixel] > 1e-3F) continue;
    auto& sum = sums[one.bin];
    const double ratio = lit(one.pixel) / one.sunlit - lit(other.pixel) / other.sunlit;
    sum.squares += ratio * ratio * one.sunlit * other.sunlit;
    ++sum.pairs;
  }
  return sums;
}

/// Prior of the factor on the computed glow: a lens's usual share of light, times the photograph's scale, the median
/// over its sound bins.
Uncertain usual_glow(const FitScene& scene, std::size_t k, std::span<const Sum> sums) {
  constexpr double share = 0.03, error = 0.02;
  std::vector<double> scales;
  for (std::size_t b = 0; b < sums.size(); ++b)
    if (sums[b].sound() && sums[b].ratio() > 0 && scene.usual_values(b, k) > 0)
      scales.push_back(sums[b].ratio() / scene.usual_values(b, k));
  if (scales.empty()) return {0, 1};
  const auto middle = scales.begin() + std::ssize(scales) / 2;
  std::ranges::nth_element(scales, middle);
  return {share * *middle, error * *middle};
}

/// Value of a square of pixels that become one.
float shrunk_pixel(const texture::Image& photo, std::size_t top, std::size_t left, std::size_t k,
                   std::size_t side) {
  float sum = 0, most = 0;
  std::size_t black = 0;
  for (std::size_t r = top; r < top + side; ++r)
    for (std::size_t c = left; c < left + side; ++c) {
      const float value = photo(r, c, k);
      sum += value;
      most = std::max(most, value);
      black += value <= 0;
    }
  const auto all = side * side;
  return most > nearly_clipped ? most : 2 * black > all ? 0 : sum / static_cast<float>(all);
}

/// Disc in a photograph, or where noise hides its limb in one of half or a quarter of the size.
colour::Disc disc_in(const Channel& luminance) {
  for (const double size : {1., 0.5, 0.25}) {
    const auto extent = [&](std::size_t pixels) {
      return static_cast<std::size_t>(static_cast<double>(pixels) * size);
    };
    const auto disc = colour::limb_of(size == 1 ? luminance
                                                : colour::resampled(luminance, {.scale = size},
                                                                    extent(luminance.rows()),
                                                                    extent(luminance.columns())));
    if (disc) return {disc->x_px / size, disc->y_px / size, disc->radius_px / size};
  }
  throw algebra::Error(
      "no Moon found, allowed is one with a quarter of its limb in the picture, neither clipped "
      "nor "
      "lost in noise");
}

/// Registration by a luminance, at full size or less.
colour::Registration registered_by(const Channel& luminance, const FitScene& scene,
                                   const MoonPart& moon, const std::optional<double>& scale,
                                   bool roughly) {
  std::exception_ptr first;
  for (double size = 1;; size /= 2) {
    const colour::Similarity smaller{.scale = size};
    const auto extent = [&](std::size_t pixels) {
      return static_cast<std::size_t>(static_cast<double>(pixels) * size);
    };
    try {
      colour::KnownBefore known{.scale = scale, .roughly = roughly};
      // finely both discs are by their limbs, whose errors are alike
      if (roughly) known.in_render = scene.disc;
      if (size == 1) known.in_photo = moon.disc;
      if (scale) *known.scale *= size;
      auto found = colour::registered(
          size == 1 ? luminance
                    : colour::resampled(luminance, smaller, extent(luminance.rows()),
                                        extent(luminance.columns())),
          scene.usual, known);
      found.render_to_photo = colour::composed(found.render_to_photo, colour::inverse(smaller));
      for (double* of_disc :
           {&found.in_photo.x_px, &found.in_photo.y_px, &found.in_photo.radius_px})
        *of_disc /= size;
      return found;
    } catch (const algebra::Error&) {
      if (!first) first = std::current_exception();
      if (roughly || size <= 0.25) std::rethrow_exception(first);
    }
  }
}

}  // namespace

MoonPart moon_part(const texture::Image& photo) {
  constexpr double margin = 1.8, least_radius_px = 0.75 * fit_disc_share * fit_side_px;
  const auto disc = disc_in(luminance_of(photo));
  const auto window = colour::window_about({disc.x_px, disc.y_px, margin * disc.radius_px},
                                           photo.height, photo.width);
  const auto by =
      static_cast<std::size_t>(std::max(1., std::floor(disc.radius_px / least_radius_px)));
  MoonPart part{.photo = {window.columns / by, window.rows / by, photo.channels},
                .shrunk = static_cast<double>(by)};
  for (std::size_t r = 0; r < part.photo.height; ++r)
    for (std::size_t c = 0; c < part.photo.width; ++c)
      for (std::size_t k = 0; k < photo.channels.size(); ++k)
        part.photo(r, c, k) = shrunk_pixel(photo, window.top + r * by, window.left + c * by, k, by);
  part.luminance = part.clipped = luminance_of(part.photo);
  const auto clipped = clipped_in(part.photo, nearly_clipped);
  const float most = *std::ranges::max_element(part.luminance.values());
  for (std::size_t i = 0; i < clipped.values().size(); ++i)
    if (clipped.values()[i] > 0) part.clipped.values()[i] = most;
  const auto within = [&](double at, std::size_t from) {
    return (at - static_cast<double>(from)) / part.shrunk;
  };
  part.disc = {within(disc.x_px, window.left), within(disc.y_px, window.top),
               disc.radius_px / part.shrunk};
  for (std::size_t k = 0; k < part.steps.size(); ++k) part.steps[k] = step_of(photo, k);
  return part;
}

std::string reason_with_shares(const MoonPart& moon, const std::string& reason) {
  constexpr double half = 0.5;
  const auto clipped = clipped_in(moon.photo, nearly_clipped);
  double all = 0, bright = 0, dark = 0;
  for (std::size_t r = 0; r < moon.photo.height; ++r)
    for (std::size_t c = 0; c < moon.photo.width; ++c) {
      const double away = std::hypot(static_cast<double>(c) + 0.5 - moon.disc.x_px,
                                     static_cast<double>(r) + 0.5 - moon.disc.y_px);
      if (away > moon.disc.radius_px) continue;
      ++all;
      bright += clipped(r, c);
      dark += moon.luminance(r, c) < colour::least_displayed;
    }
  if (bright + dark < half * all) return reason;
  return fmt::format(
      "{}; {:.0f} % of the Moon is clipped and {:.0f} % dark, half of it or more should be neither "
      "clipped nor lost in noise",
      reason, 100 * bright / all, 100 * dark / all);
}

colour::Registration registration_of(const FitScene& scene, const MoonPart& moon,
                                     const std::optional<double>& scale, Registering how) {
  constexpr double well = 0.8;
  std::optional<colour::Registration> best;
  std::exception_ptr first;
  for (const auto* luminance : {&moon.luminance, &moon.clipped}) {
    try {
      const auto found = registered_by(*luminance, scene, moon, scale, how == Registering::rough);
      if (!best || found.correlation > best->correlation) best = found;
    } catch (const algebra::Error&) {
      if (!first) first = std::current_exception();
    }
    if (how != Registering::of_clipped || (best && best->correlation >= well)) break;
  }
  if (!best) std::rethrow_exception(first);
  return *best;
}

namespace {

const double scene_pixel_km =
    2 * algebra::in_kilometres(almanac::lunar_radius) / (fit_disc_share * fit_side_px);

/// Larger pixels of photograph and scene, over the scene's.
double larger_pixel(const colour::Registration& registration) {
  return 1 / std::min(1., registration.render_to_photo.scale);
}

}  // namespace

double off_limb_km(const FitScene& scene, const colour::Registration& registration) {
  constexpr double of_limb = 0.3;
  const auto& limb = registration.in_photo;
  const auto middle =
      colour::moved(registration.render_to_photo, {scene.disc.x_px, scene.disc.y_px});
  const double apart_px =
      std::hypot(middle.x - limb.x_px, middle.y - limb.y_px) / registration.render_to_photo.scale;
  return std::max(0., apart_px - of_limb * larger_pixel(registration)) * scene_pixel_km;
}

double place_error_km(const FitScene& scene, const colour::Registration& registration,
                      bool in_its_air) {
  constexpr double in_umbra = 0.3, with_crescent = 0.8, of_known_air = 0.2, by_noise = 2;
  const double pixels = std::hypot(in_its_air                 ? of_known_air
                                   : lies_in_umbra(scene.sky) ? in_umbra
                                                              : with_crescent,
                                   by_noise * (1 - registration.correlation));
  return std::hypot(pixels * larger_pixel(registration) * scene_pixel_km,
                    off_limb_km(scene, registration));
}

BinnedPhotograph binned(const FitScene& scene, const MoonPart& moon,
                        const colour::Similarity& render_to_photo,
                        const std::optional<colour::ToneCurve>& curve) {
  constexpr double least_steps = 6, least_skies = 5;
  const algebra::Grid<double> none(scene.bins, 3);
  BinnedPhotograph result{none, none, none, none, {}};
  if (curve) result.slopes = algebra::Grid<ToneSlopes>(scene.bins, 3);
  const auto& photo = moon.photo;
  const auto glow = scene.glow.empty() ? glow_of(scene) : scene.glow;
  const auto back = colour::inverse(render_to_photo);
  const auto brought = [&](const Channel& channel) {
    return std::ranges::all_of(channel.values(), [](float value) { return value == 0; })
               ? Channel(fit_side_px, fit_side_px)
               : colour::resampled(channel, back, fit_side_px, fit_side_px);
  };
  const colour::ToneTable table(curve.value_or(colour::ToneCurve{}));
  const auto clipped =
      brought(clipped_in(photo, curve ? static_cast<float>(colour::most_displayed) : 0.97F));
  const double noise_of_means = colour::noise_of_means(render_to_photo.scale);
  const double stretched = curve ? std::exp(colour::tone_logarithm(*curve, 0)) : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto channel = channel_of(photo, k);
    Brought there{brought(channel), {}, brought(mapped(channel, is_black)), plane_of(glow, k)};
    there.light = curve ? brought(mapped(channel, table)) : there.displayed;
    const double step = stretched * moon.steps[k];
    const auto around = around_the_disc(there.light);
    Off off{median_of(around_the_disc(there.displayed)), median_of(around), 0};
    const auto usual = usual_glow(scene, k, sums_of(scene, there, clipped, off, false));
    const auto [sky, of_glow] =
        light_beside(around, around_the_disc(there.black), around_the_disc(there.glow), usual,
                     !curve || off.displayed >= colour::least_displayed);
    off.sky = sky.value;
    if (off.sky == 0) off.displayed = 0;
    off.glow = of_glow.value;
    const auto sums = sums_of(scene, there, clipped, off, curve.has_value());
    for (std::size_t b = 0; b < scene.bins; ++b) {
      const auto& sum = sums[b];
      const double mean = sum.mean();
      if (!sum.sound() || (curve && !sum.bright_enough()) || mean <= least_steps * step ||
          mean <= least_skies * sky.error)
        continue;
      result.values(b, k) = sum.ratio();
      result.errors(b, k) =
          std::hypot(sum.error(noise_of_means), sum.error_of_steps(step, curve.has_value()));
      result.sky_errors(b, k) = sky.error / mean * sum.ratio();
      result.glow_errors(b, k) = of_glow.error * sum.glow / sum.sunlit;
      if (!curve) continue;
      for (std::size_t n = 0; n < colour::tone_numbers; ++n)
        result.slopes(b, k)[n] = sum.slopes[n] / sum.light;
    }
  }
  return result;
}

}  // namespace coppermoon::uses
