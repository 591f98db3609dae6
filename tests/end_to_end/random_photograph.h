// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "colour/camera.h"
#include "colour/glow.h"
#include "colour/photograph.h"
#include "colour/similarity.h"
#include "end_to_end/random_numbers.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"
#include "uses/fit/unknowns.h"
#include "uses/picture/pixels.h"

namespace coppermoon::end_to_end {

/// An eclipse, and where it is seen from.
struct Occasion {
  const char* instant;
  double latitude, longitude;  // [degrees]

  std::string at() const { return fmt::format("{},{}", latitude, longitude); }
};

inline constexpr std::array occasions{
    Occasion{"2018-07-27T20:40:00Z", 36, 38}, Occasion{"2008-02-21T03:12:00Z", 42.86, -73.77},
    Occasion{"2015-09-28T02:30:00Z", 30, -40}, Occasion{"2010-12-21T08:00:00Z", 40, -100},
    Occasion{"2000-07-16T13:20:00Z", -20, 150}};

/// Air of one column.
struct ColumnTruth {
  double dust_per_m, cloud_cover, ozone_du;
};

/// A photograph that was taken.
struct Taken {
  ColumnTruth truth;
  bool jpeg;
  double time_s, iso, seeing_arcsec;
};

/// Ozone is drawn from all that a fit allows: a noisy photograph tells so little of it that an interval holds
/// the truth as often as it says over that range alone.
inline Taken random_photograph(Random& random) {
  Taken taken{};
  const auto& ozone = uses::unknowns_of(uses::Unknowns::amounts)[2];
  taken.truth = {log_between(random, 1.5e-6, 1e-5), between(random, 0, 0.9),
                 between(random, ozone.least, ozone.most)};
  taken.jpeg = random.uniform() < 0.5;
  taken.time_s = between(random, 1, 4);
  taken.iso = log_between(random, 100, 3200);
  taken.seeing_arcsec = between(random, 1, 4);
  return taken;
}

/// Turned about its middle, as a camera that is not level holds it.
inline texture::Image turned(const texture::Image& image, double angle_rad) {
  texture::Image result(image.width, image.height, image.channels);
  const double x0 = static_cast<double>(image.width) / 2,
               y0 = static_cast<double>(image.height) / 2, c = std::cos(angle_rad),
               s = std::sin(angle_rad);
  for (std::size_t k = 0; k < 3; ++k) {
    algebra::Grid<float> channel(image.height, image.width);
    for (std::size_t i = 0; i < channel.values().size(); ++i)
      channel.values()[i] = image.values[image.channels.size() * i + k];
    for (std::size_t r = 0; r < image.height; ++r)
      for (std::size_t col = 0; col < image.width; ++col) {
        const double x = static_cast<double>(col) + 0.5 - x0, y = static_cast<double>(r) + 0.5 - y0;
        result(r, col, k) = static_cast<float>(
            colour::between_pixels(channel, {x0 + c * x - s * y, y0 + s * x + c * y}));
      }
  }
  return result;
}

/// A frame of a Moon whose map is 1.2 % off in cells of 200 km, each channel by itself: over a step of
/// distance from the axis that comes to the 0.3 % to which a fit believes its map.
inline void mar_map(texture::Image& frame, Random& random) {
  constexpr std::size_t cell_px = 18;
  constexpr double error = 0.012;
  const auto across = frame.width / cell_px + 1;
  std::vector<float> factors;
  for (std::size_t i = 0; i < across * (frame.height / cell_px + 1) * 3; ++i)
    factors.push_back(static_cast<float>(std::exp(error * normal(random))));
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        frame(r, c, k) *= factors[(r / cell_px * across + c / cell_px) * 3 + k];
}

/// A frame on whose Moon the glow is off by a quarter, as much as a fit believes: what is measured beside the
/// disc tells of its strength, but not of its shape.
inline void mar_glow(texture::Image& frame, double share, double pixel_rad, Random& random) {
  constexpr double believed = 0.25;
  const auto seen = uses::pixels_of(frame), glowing = colour::with_glow(seen, share, pixel_rad);
  const double error = believed * normal(random);
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto channel = static_cast<int>(k);
        const double kept = seen(r, c)[channel];
        if (kept > 0)
          frame(r, c, k) +=
              static_cast<float>(error * (glowing(r, c)[channel] - (1 - share) * kept));
      }
}

/// Photographs of POV-Ray's frames, marred by as much as a fit believes.
class PhotographsTest : public ProgramTest {
 protected:
  /// A scene-linear frame by POV-Ray, of the true air.
  texture::Image frame_of(const Occasion& occasion, const Words& air) const {
    const auto still = words_of(
        "still {} --at {} -o a.png --width 440 --height 440 --field 0.75 --time 1 --albedo-map "
        "built-in --texture-width 1024 --stars off --frame frame.exr",
        occasion.instant, occasion.at());
    const auto outcome = coppermoon(still + air);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return texture::read_image(here("frame.exr"));
  }

  /// File of it as a camera that is sold as f/6 and saturates within a tenth of what its speed says has it.
  ///
  /// Given     noise            seed and number of its pixels' noise
  /// Given     random           for what is off: map, glow, exposure, white balance, angle
  /// Returned  value_per_cd_m2  as its exposure and speed say
  std::string photograph_of(texture::Image frame, const Taken& taken, Random& random,
                            const std::array<std::uint64_t, 2>& noise,
                            double& value_per_cd_m2) const {
    auto camera = colour::camera_named("refractor");
    const double pixel_rad = 2 * std::tan(0.75 / 2 * std::numbers::pi / 180) / 440;
    mar_map(frame, random);
    mar_glow(frame, camera.glow, pixel_rad, random);
    const double exposed = std::exp(0.1 * normal(random));
    const std::array<double, 3> gain{exposed * std::exp(0.03 * normal(random)), exposed,
                                     exposed * std::exp(0.03 * normal(random))};
    for (std::size_t i = 0; i < frame.values.size(); ++i)
      frame.values[i] *= static_cast<float>(gain[i % 3]);
    camera.seeing_arcsec = taken.seeing_arcsec;
    const double f_number = camera.optics.focal_length_mm / camera.optics.aperture_mm;
    const colour::Exposure exposure{taken.time_s, f_number, taken.iso};
    const auto photograph =
        colour::photographed(uses::pixels_of(frame), colour::WorkingSpace::linear_rec709, camera,
                             {exposure, pixel_rad, 2e-4, noise[0], noise[1]});
    value_per_cd_m2 = 1 / photograph.saturation_cd_m2;
    auto image = uses::image_of(photograph.scene_linear);
    for (float& value : image.values) value *= static_cast<float>(value_per_cd_m2);
    return written(turned(image, between(random, 0, 6.28)), taken.jpeg);
  }

  /// File of an image, coded as sRGB.
  std::string written(texture::Image image, bool jpeg) const {
    for (float& value : image.values) {
      const float v = std::clamp(value, 0.F, 1.F);
      value = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
    }
    texture::write_png(here("photo.png"), image, 16);
    if (!jpeg) return "photo.png";
    const auto outcome = run(words_of("oiiotool {} -d uint8 --compression jpeg:90 -o {}",
                                      here("photo.png"), here("photo.jpg")));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return "photo.jpg";
  }
};

}  // namespace coppermoon::end_to_end
