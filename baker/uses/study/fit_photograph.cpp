// SPDX-License-Identifier: MIT
#include "uses/study/fit_photograph.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <numeric>

#include "algebra/error.h"
#include "uses/picture/pixels.h"
#include "uses/study/comparison.h"

namespace coppermoon::uses {
namespace {

using Channel = algebra::Grid<float>;

/// Means of a channel around the disc, in twelve parts of the circle.
std::vector<double> around_the_disc(const Channel& channel) {
  constexpr std::size_t parts = 12;
  const double middle = fit_side_px / 2., radius = fit_disc_share * middle;
  std::vector<double> sums(parts), counts(parts);
  for (std::size_t r = 0; r < fit_side_px; ++r)
    for (std::size_t c = 0; c < fit_side_px; ++c) {
      const double x = static_cast<double>(c) + 0.5 - middle,
                   y = static_cast<double>(r) + 0.5 - middle, away = std::hypot(x, y);
      if (away <= 1.12 * radius || away >= 1.24 * radius) continue;
      const double turn = std::atan2(y, x) / (2 * std::numbers::pi) + 0.5;
      const auto part = std::min(static_cast<std::size_t>(turn * parts), parts - 1);
      sums[part] += channel(r, c);
      ++counts[part];
    }
  for (std::size_t i = 0; i < parts; ++i) sums[i] /= counts[i];
  std::ranges::sort(sums);
  return sums;
}

/// Light that the sky adds, and how far it may be off.
struct Sky {
  double light = 0, doubt = 0;
};

/// The median around the disc, for sunlit ground spreads its light about it, and half of the middle half's
/// width. Where noise is cut off at black nothing is taken off: the sky has at most what is left there.
Sky sky_in(const Channel& light, const Channel& black) {
  constexpr double much = 0.05;
  const auto around = around_the_disc(light), dark = around_the_disc(black);
  const auto parts = around.size();
  const double median = (around[parts / 2 - 1] + around[parts / 2]) / 2,
               spread = (around[3 * parts / 4] - around[parts / 4 - 1]) / 2;
  const double black_share = std::reduce(dark.begin(), dark.end()) / static_cast<double>(parts);
  return black_share > much ? Sky{0, std::max(median, spread)} : Sky{median, spread};
}

/// The least step of a channel that has 256 values at most: sRGB's near black; else 0.
double step_of(const Channel& channel) {
  std::vector<float> values(channel.values().begin(), channel.values().end());
  std::ranges::sort(values);
  const auto end = std::unique(values.begin(), values.end());
  return end - values.begin() <= 256 ? 1 / 12.92 / 255 : 0;
}

/// One bin's light over its sunlight, and how well that is known.
struct Sum {
  double light = 0, displayed = 0, sunlit = 0, residual = 0, black = 0;
  std::size_t pixels = 0, clipped = 0;
  ToneSlopes slopes{};  ///< of its light

  /// Noise that is cut off at black, or light that is at saturation, is none to average over.
  bool sound() const {
    constexpr double few = 0.02;
    const auto all = static_cast<double>(pixels);
    return pixels >= 40 && static_cast<double>(clipped) <= 0.005 * all && black <= few * all;
  }
  /// Whether tone curves are known for as little light.
  bool bright_enough() const {
    return displayed >= colour::least_displayed * static_cast<double>(pixels);
  }
  double ratio() const { return light / sunlit; }
  /// Neighbouring pixels are in part as wrong as each other.
  double error() const {
    constexpr double alike = 1.5;
    const double variance = residual / static_cast<double>(pixels);
    return std::sqrt(alike * variance * static_cast<double>(pixels)) / sunlit;
  }
};

/// 1 where a channel is black.
Channel black_in(const Channel& light) {
  Channel black(light.rows(), light.columns());
  for (std::size_t i = 0; i < black.values().size(); ++i)
    black.values()[i] = light.values()[i] <= 0 ? 1 : 0;
  return black;
}

/// 1 where any channel is clipped.
Channel clipped_in(const texture::Image& photo, float saturated) {
  Channel clipped(photo.height, photo.width);
  for (std::size_t i = 0; i < clipped.values().size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (photo.values[photo.channels.size() * i + k] >= saturated) clipped.values()[i] = 1;
  return clipped;
}

/// A channel in the scene's picture: its light, as displayed and as the scene's.
struct Brought {
  Channel displayed, light, black;
};

/// Adds how the light of a pixel above the sky's changes with the numbers of a curve.
void add_slopes(ToneSlopes& slopes, double light, double displayed, double sky,
                double sky_displayed) {
  const auto of_light = colour::tone_derivatives(displayed),
             of_sky = colour::tone_derivatives(sky_displayed);
  for (std::size_t k = 0; k < slopes.size(); ++k)
    slopes[k] += light * of_light[k] - sky * of_sky[k];
}

/// Light of the sky, as displayed and as the scene's.
struct BothSkies {
  double displayed, light;
};

std::vector<Sum> sums_of(const FitScene& scene, const Brought& channel, const Channel& clipped,
                         BothSkies sky, bool curved) {
  const auto& light = channel.light;
  std::vector<Sum> sums(scene.bins);
  const auto lit = [&](std::size_t pixel) { return light.values()[pixel] - sky.light; };
  for (const auto& [pixel, ground, sunlit, bin] : scene.grounds) {
    auto& sum = sums[bin];
    ++sum.pixels;
    sum.black += channel.black.values()[pixel];
    if (clipped.values()[pixel] > 1e-3F) {
      ++sum.clipped;
      continue;
    }
    sum.light += lit(pixel);
    sum.displayed += channel.displayed.values()[pixel];
    sum.sunlit += sunlit;
    if (curved)
      add_slopes(sum.slopes, light.values()[pixel], channel.displayed.values()[pixel], sky.light,
                 sky.displayed);
  }
  for (const auto& [pixel, ground, sunlit, bin] : scene.grounds) {
    auto& sum = sums[bin];
    if (clipped.values()[pixel] > 1e-3F || sum.sunlit == 0) continue;
    sum.residual += std::pow(lit(pixel) - sum.ratio() * sunlit, 2);
  }
  return sums;
}

Channel as_scene(const Channel& displayed, const colour::ToneTable& table) {
  auto light = displayed;
  for (float& value : light.values()) value = table(value);
  return light;
}

}  // namespace

colour::Registration registration_of(const FitScene& scene, const texture::Image& photo) {
  const auto luminance = luminance_of(photo);
  std::exception_ptr of_itself;
  for (double size = 1;; size /= 2) {
    const colour::Similarity smaller{.scale = size};
    const auto extent = [&](std::size_t pixels) {
      return static_cast<std::size_t>(static_cast<double>(pixels) * size);
    };
    try {
      auto found = colour::registered(
          size == 1
              ? luminance
              : colour::resampled(luminance, smaller, extent(photo.height), extent(photo.width)),
          scene.usual);
      found.render_to_photo = colour::composed(found.render_to_photo, colour::inverse(smaller));
      return found;
    } catch (const algebra::Error&) {
      if (!of_itself) of_itself = std::current_exception();
      if (size <= 0.25) std::rethrow_exception(of_itself);
    }
  }
}

BinnedPhotograph binned(const FitScene& scene, const texture::Image& photo,
                        const colour::Similarity& render_to_photo,
                        const std::optional<colour::ToneCurve>& curve) {
  constexpr double least_steps = 6, of_a_step = 0.3, least_skies = 5;
  BinnedPhotograph result{algebra::Grid<double>(scene.bins, 3),
                          algebra::Grid<double>(scene.bins, 3),
                          algebra::Grid<double>(scene.bins, 3),
                          {}};
  if (curve) result.slopes = algebra::Grid<ToneSlopes>(scene.bins, 3);
  const auto back = colour::inverse(render_to_photo);
  const auto brought = [&](const Channel& channel) {
    return colour::resampled(channel, back, fit_side_px, fit_side_px);
  };
  const colour::ToneTable table(curve.value_or(colour::ToneCurve{}));
  const auto clipped =
      brought(clipped_in(photo, curve ? static_cast<float>(colour::most_displayed) : 0.97F));
  const double stretched = curve ? std::exp(colour::tone_logarithm(*curve, 0)) : 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto channel = channel_of(photo, k);
    Brought there{brought(channel), {}, brought(black_in(channel))};
    there.light = curve ? brought(as_scene(channel, table)) : there.displayed;
    const double step = stretched * step_of(channel);
    const auto sky = sky_in(there.light, there.black);
    const auto sums =
        sums_of(scene, there, clipped, {sky_in(there.displayed, there.black).light, sky.light},
                curve.has_value());
    for (std::size_t b = 0; b < scene.bins; ++b) {
      const auto& sum = sums[b];
      const double mean = sum.light / static_cast<double>(std::max<std::size_t>(1, sum.pixels));
      if (!sum.sound() || (curve && !sum.bright_enough()) || mean <= least_steps * step ||
          mean <= least_skies * sky.doubt)
        continue;
      result.values(b, k) = sum.ratio();
      result.errors(b, k) = std::hypot(sum.error(), of_a_step * step / mean * sum.ratio());
      result.sky_errors(b, k) = sky.doubt / mean * sum.ratio();
      if (!curve) continue;
      for (std::size_t n = 0; n < colour::tone_numbers; ++n)
        result.slopes(b, k)[n] = sum.slopes[n] / sum.light;
    }
  }
  return result;
}

}  // namespace coppermoon::uses
