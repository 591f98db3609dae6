// SPDX-License-Identifier: MIT
#include "uses/fit/binned_photograph.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "uses/fit/sky_and_glow.h"
#include "uses/picture/pixels.h"

namespace coppermoon::uses {
namespace {

/// Standard deviation of rounding errors, in quantisation steps.
constexpr double of_a_step = 0.3;

using Channel = algebra::Grid<float>;

Channel plane_of(const colour::Image& image, std::size_t k) {
  Channel channel(image.rows(), image.columns());
  for (std::size_t i = 0; i < channel.values().size(); ++i)
    channel.values()[i] = image.values()[i][k];
  return channel;
}

/// Separates the light beside the disc, in one channel, into light from the sky and glow from the lens. If many pixels
/// there are black, the sky's light is taken as 0, and the measured light as its standard error. If the sky is too dark
/// for the tone curve to be known, the glow keeps its prior.
SkyAndGlow light_beside(const AroundTheDisc& light, const AroundTheDisc& black,
                        const AroundTheDisc& glow, Uncertain prior, bool linear, double step) {
  constexpr double much = 0.05, of_glow = 0.25, fixed = 1e-9;
  const double black_share =
      std::reduce(black.begin(), black.end()) / static_cast<double>(black.size());
  if (black_share > much) {
    const double most =
        std::max(step, std::ranges::max(light)) / std::max(1e-300, std::ranges::max(glow));
    if (most < prior.value) prior = {most / 2, std::max(most / 2, fixed)};
  }
  auto found = sky_and_glow(light, glow, linear ? prior : Uncertain{prior.value, fixed});
  if (!linear) found.glow = prior;
  if (black_share > much) found = {{0, std::max(median_of(light), found.sky.error)}, prior};
  found.glow.error = std::hypot(found.glow.error, of_glow * found.glow.value);
  return found;
}

/// Sums over the pixels of a bin.
struct SumOfBin {
  double light = 0, displayed = 0, sunlit = 0, glow = 0, black = 0;
  double squares = 0;        ///< sum of squared differences between pixels two columns apart
  double light_squares = 0;  ///< sum of the pixels' squared light
  std::size_t pixels = 0, clipped = 0, pairs = 0;
  ToneSlopes slopes{};  ///< sums of light's derivatives with respect to the tone curve's parameters

  /// Whether few enough pixels are black or clipped for the mean of the others to be unbiased.
  bool sound() const {
    constexpr double few = 0.02;
    const auto all = static_cast<double>(pixels);
    return pixels >= 40 && static_cast<double>(clipped) <= 0.005 * all && black <= few * all;
  }
  /// Whether the pixels are bright enough, on average, for the tone curve to be known there.
  bool bright_enough() const {
    return displayed >= colour::least_displayed * static_cast<double>(pixels);
  }
  double ratio() const { return light / sunlit; }
  double mean() const { return light / static_cast<double>(std::max<std::size_t>(1, pixels)); }
  /// Standard error of ratio() that comes from rounding pixel values to steps. Rounding errors average out if light
  /// varies between pixels by more than half a step. In a JPEG, however, the pixels of a block share the error of their
  /// colour. With a camera's own tone curve, all pixels share one error, because near black the curve is not known to
  /// within a step.
  double error_of_steps(double step, bool curved) const {
    constexpr double two_pi_squared = 2 * std::numbers::pi * std::numbers::pi, block = 256;
    if (step <= 0) return 0;
    const double of_pixel = of_a_step * step / mean() * ratio();
    if (curved) return of_pixel;
    const auto all = static_cast<double>(std::max<std::size_t>(1, pixels));
    const double variance = std::max(0., light_squares / all - mean() * mean());
    return of_pixel * std::hypot(std::exp(-two_pi_squared * variance / (step * step)),
                                 std::sqrt(std::min(1., block / all)));
  }
  /// Standard error of ratio() that comes from noise. It is estimated from pixels two columns apart, because the light
  /// itself varies across a bin.
  ///
  /// Given  noise_of_means  result of colour::noise_of_means
  double error(double noise_of_means) const {
    const double variance = squares / 2 / static_cast<double>(std::max<std::size_t>(1, pairs));
    return std::sqrt(noise_of_means * variance * static_cast<double>(pixels)) / sunlit;
  }
};

/// Applies a function to each value of a channel.
template <class Function>
Channel mapped(Channel channel, const Function& function) {
  for (float& value : channel.values()) value = function(value);
  return channel;
}

float is_black(float value) { return value <= 0 ? 1 : 0; }

/// One channel of a photograph, resampled to the pixels of the scene.
struct Brought {
  Channel displayed;  ///< sRGB-coded values
  Channel light;      ///< light, with the tone curve undone
  Channel black;      ///< share of black pixels
  Channel glow;       ///< glow computed for the assumed air
};

/// Adds the derivatives of a pixel's light with respect to a tone curve's parameters. The sky's light is subtracted.
void add_slopes(ToneSlopes& slopes, double light, double displayed, double sky,
                double sky_displayed) {
  const auto of_light = colour::tone_derivatives(displayed),
             of_sky = colour::tone_derivatives(sky_displayed);
  for (std::size_t k = 0; k < slopes.size(); ++k)
    slopes[k] += light * of_light[k] - sky * of_sky[k];
}

/// What to subtract from each pixel: the sky's light, both sRGB-coded and linear, and a multiple of the computed glow.
struct Off {
  double displayed, sky, glow;
};

std::vector<SumOfBin> sums_of(const FitScene& scene, const Brought& channel, const Channel& clipped,
                              const Off& off, bool curved) {
  const auto& light = channel.light;
  std::vector<SumOfBin> sums(scene.bins);
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

/// Prior of the factor on the computed glow. It is the share of light that a lens typically scatters, times the ratio
/// of photographed to computed light. The ratio is the median over all bins with few black or clipped pixels.
Uncertain usual_glow(const FitScene& scene, std::size_t k, std::span<const SumOfBin> sums) {
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

}  // namespace

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
  const auto clipped = brought(clipped_in(photo, moon.saturated));
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
    auto [sky, of_glow] =
        light_beside(around, around_the_disc(there.black), around_the_disc(there.glow), usual,
                     !curve || off.displayed >= colour::least_displayed, step);
    if (!curve) sky.error = std::hypot(sky.error, of_a_step * step);
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
