// SPDX-License-Identifier: MIT
#pragma once

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "algebra/grid.h"
#include "algebra/random.h"
#include "colour/moon_limb.h"

namespace coppermoon::colour {

/// A photograph of the eclipsed Moon as JPEG, by a model of its own: a disc with maria and limb darkening,
/// the shadow's two circles, glow, blur, noise, clipping, sRGB's curve.
struct TakenMoon {
  std::size_t columns = 600, rows = 400;
  Disc disc{300, 200, 100};
  double shadow_x = 9, shadow_y = 0;  ///< of the shadow's middle from the disc's [radii]
  double umbra = 1e-4;                ///< light in its middle's half, over full sunlight
  double exposure = 0.8;              ///< brightest sunlit ground over saturation
  double sky = 0, glow = 0;           ///< over saturation; light about the disc, over its mean
  int blur = 1;                       ///< three means over 2 × blur + 1 pixels, both ways
  double noise = 0.003;               ///< at saturation; half that of no light
  int quality = 90;                   ///< of JPEG, 1 to 100
  std::uint64_t seed = 1;
};

using Rgb = std::array<double, 3>;

inline double blur_px(const TakenMoon& moon) { return std::sqrt(moon.blur * (moon.blur + 1.)); }

/// Light of the ground at a place on the disc [radii], over saturation.
inline Rgb ground_light(const TakenMoon& moon, double x, double y) {
  constexpr double umbra_radius = 2.7, penumbra_radius = 4.6;  // of the Moon's
  constexpr Rgb reddened{1, 0.35, 0.15};
  const double depth = std::sqrt(std::max(0., 1 - x * x - y * y));
  const double phase = static_cast<double>(moon.seed % 97);
  const double maria = std::sin(3.1 * x + 2.3 * y + phase) * std::sin(4.3 * y - 1.9 * x + phase) +
                       0.4 * std::sin(9.7 * x + phase) * std::sin(8.9 * y + 2 * phase);
  const double albedo = (0.82 + 0.18 * std::clamp(2 * maria, -1., 1.)) * (0.85 + 0.15 * depth);
  const double away = std::hypot(x - moon.shadow_x, y - moon.shadow_y);
  const double out = std::clamp((away - umbra_radius) / (penumbra_radius - umbra_radius), 0., 1.);
  const double in_umbra = moon.umbra * std::pow(10, 0.75 * (std::min(away, umbra_radius) - 1.35));
  Rgb light{};
  for (std::size_t k = 0; k < 3; ++k)
    light[k] = moon.exposure * albedo * (std::pow(out, 1.5) + reddened[k] * in_umbra);
  return light;
}

inline double coded(double light) {
  light = std::clamp(light, 0., 1.);
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

inline double decoded(double code) {
  return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

/// What a photograph can tell of a limb.
struct Tellable {
  int degrees = 0;      ///< of the limb that a person sees
  double bloom_px = 0;  ///< how far outward the most clipped of it seems
};

/// A person sees a step of four codes of 255 that exceeds twice a pixel's noise. Half of what is left of a
/// limb A times saturation stands where the blurred step is 1/2A: so far is it out.
inline Tellable tellable(const TakenMoon& moon) {
  Tellable seen;
  for (int degree = 0; degree < 360; ++degree) {
    const double x = std::cos(degree * std::numbers::pi / 180),
                 y = std::sin(degree * std::numbers::pi / 180);
    const double at_x = moon.disc.x_px + moon.disc.radius_px * x,
                 at_y = moon.disc.y_px + moon.disc.radius_px * y;
    const double margin = 0.1 * moon.disc.radius_px + 3;
    if (at_x < margin || at_y < margin || at_x > static_cast<double>(moon.columns) - margin ||
        at_y > static_cast<double>(moon.rows) - margin)
      continue;
    const Rgb light = ground_light(moon, 0.97 * x, 0.97 * y);
    const double sky = moon.sky + moon.glow * moon.exposure * 0.5;
    const double most = light[0];  // red is never less
    const double noise = moon.noise * std::sqrt(0.25 + 0.75 * std::min(1., sky));
    const double step = coded(sky + most) - coded(sky);
    if (step < 4 / 255. || std::min(most, 1 - sky) < 2 * noise) continue;
    ++seen.degrees;
    double low = 0, high = 6;  // of erfc, by halving
    for (int i = 0; i < 40; ++i) {
      const double middle = 0.5 * (low + high);
      (std::erfc(middle / std::numbers::sqrt2) > std::min(1., (1 - sky) / most) ? low : high) =
          middle;
    }
    seen.bloom_px = std::max(seen.bloom_px, low * std::hypot(blur_px(moon), 0.29));
  }
  return seen;
}

/// How far a finder may be off. Registration begins with steps of 1.5 % of the radius, so 2 % will do;
/// pixels are whole, half of blur may count as ground or sky, bloom is seen as limb. Such an error of the
/// limb moves the circle through a piece of it by 1 / (1 - cos(half its angle)).
inline double tolerance_px(const TakenMoon& moon, const Tellable& seen) {
  const double lever =
      std::max(1., 1 / (1 - std::cos(0.5 * seen.degrees * std::numbers::pi / 180)));
  return lever * (0.02 * moon.disc.radius_px + 0.5 + 0.5 * blur_px(moon) + seen.bloom_px);
}

using Channels = std::array<algebra::Grid<float>, 3>;

/// Means over 2 × reach + 1 pixels along rows, then turned over.
inline algebra::Grid<float> mean_along(const algebra::Grid<float>& from, int reach) {
  algebra::Grid<float> to(from.columns(), from.rows());
  const auto n = static_cast<int>(from.columns());
  for (std::size_t r = 0; r < from.rows(); ++r) {
    const auto line = from.row(r);
    const auto at = [&](int c) {
      return double{line[static_cast<std::size_t>(std::clamp(c, 0, n - 1))]};
    };
    double sum = 0;
    for (int c = -reach; c <= reach; ++c) sum += at(c);
    for (int c = 0; c < n; ++c) {
      to(static_cast<std::size_t>(c), r) = static_cast<float>(sum / (2 * reach + 1));
      sum += at(c + reach + 1) - at(c - reach);
    }
  }
  return to;
}

/// What falls on the sensor, without noise.
inline Channels light_of(const TakenMoon& moon) {
  Channels light;
  for (auto& channel : light) channel = algebra::Grid<float>(moon.rows, moon.columns);
  const auto& disc = moon.disc;
  Rgb sum{};
  for (std::size_t r = 0; r < moon.rows; ++r)
    for (std::size_t c = 0; c < moon.columns; ++c) {
      const double x = static_cast<double>(c) + 0.5 - disc.x_px,
                   y = static_cast<double>(r) + 0.5 - disc.y_px;
      const double away = std::hypot(x, y),
                   covered = std::clamp(disc.radius_px - away + 0.5, 0., 1.);
      if (covered <= 0) continue;
      const double unit = 1 / std::max(disc.radius_px, away);
      const Rgb ground = ground_light(moon, x * unit, y * unit);
      for (std::size_t k = 0; k < 3; ++k) {
        light[k](r, c) = static_cast<float>(covered * ground[k]);
        sum[k] += covered * ground[k];
      }
    }
  for (int pass = 0; pass < 6 && moon.blur > 0; ++pass)
    for (auto& channel : light) channel = mean_along(channel, moon.blur);
  const double area = std::numbers::pi * disc.radius_px * disc.radius_px;
  for (std::size_t r = 0; r < moon.rows; ++r)
    for (std::size_t c = 0; c < moon.columns; ++c) {
      const double away = std::hypot(static_cast<double>(c) + 0.5 - disc.x_px,
                                     static_cast<double>(r) + 0.5 - disc.y_px) /
                          disc.radius_px;
      for (std::size_t k = 0; k < 3; ++k)
        light[k](r, c) +=
            static_cast<float>(moon.sky + moon.glow * sum[k] / area / (1 + away * away));
    }
  return light;
}

/// As encoded and decoded again: the values 0 to 1 of red, green and blue, pixel by pixel.
inline std::vector<float> through_jpeg(const std::vector<std::uint8_t>& bytes,
                                       const TakenMoon& moon) {
  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput sink(file);
  auto out = OIIO::ImageOutput::create("jpg", &sink);
  OIIO::ImageSpec spec(static_cast<int>(moon.columns), static_cast<int>(moon.rows), 3,
                       OIIO::TypeDesc::UINT8);
  spec.attribute("Compression", "jpeg:" + std::to_string(moon.quality));
  out->open("moon.jpg", spec);
  out->write_image(OIIO::TypeDesc::UINT8, bytes.data());
  out->close();
  OIIO::Filesystem::IOMemReader source(OIIO::cspan<unsigned char>(file.data(), file.size()));
  auto in = OIIO::ImageInput::open("moon.jpg", nullptr, &source);
  std::vector<float> values(bytes.size());
  in->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, values.data());
  return values;
}

inline double gaussian(algebra::Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

/// Scene-linear luminance of any channels' light as a camera and JPEG leave it; what is clipped in any
/// channel is 1.
inline algebra::Grid<float> luminance_in_jpeg(const Channels& light, const TakenMoon& moon) {
  algebra::Random random(moon.seed, 77);
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i < light[0].values().size(); ++i)
    for (const auto& channel : light) {
      const double here = double{channel.values()[i]};
      const double noise =
          moon.noise == 0
              ? 0
              : moon.noise * std::sqrt(0.25 + 0.75 * std::min(1., here)) * gaussian(random);
      bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * coded(here + noise))));
    }
  const auto values = through_jpeg(bytes, moon);
  algebra::Grid<float> luminance(moon.rows, moon.columns);
  for (std::size_t i = 0; i < luminance.values().size(); ++i) {
    const double r = decoded(values[3 * i]), g = decoded(values[3 * i + 1]),
                 b = decoded(values[3 * i + 2]);
    luminance.values()[i] = std::max({r, g, b}) >= 0.99
                                ? 1.F
                                : static_cast<float>(0.2126 * r + 0.7152 * g + 0.0722 * b);
  }
  return luminance;
}

inline algebra::Grid<float> taken(const TakenMoon& moon) {
  return luminance_in_jpeg(light_of(moon), moon);
}

}  // namespace coppermoon::colour
