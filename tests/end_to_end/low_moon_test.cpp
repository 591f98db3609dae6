// SPDX-License-Identifier: MIT
// A Moon near the horizon is flattened in the frame, towards the zenith; its texture stays as it is.
#include <glm/geometric.hpp>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "povray_scenes/render.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::low_moon_test {

using algebra::degrees;

constexpr const char *instant = "2008-02-21T03:26:05Z", *at = "42,47.3";
const almanac::Observer caspian{degrees(42), degrees(47.3), {}};
constexpr int side = 360;  // pixels

almanac::ObserverView seen() {
  return almanac::view_from(caspian, almanac::sky_at(almanac::instant_from_utc(instant)));
}

/// Bennett (1982), J. Navigation 35, 255: by apparent altitude, the other way round than ours.
double apparent_altitude_deg(double true_altitude_deg) {
  double apparent = true_altitude_deg;
  for (int i = 0; i < 100; ++i)
    apparent = true_altitude_deg +
               1 / std::tan(in_radians(degrees(apparent + 7.31 / (apparent + 4.4)))) / 60;
  return apparent;
}

/// The lit pixels of a frame, by their second moments about the middle: as the squares of the
/// half-axes of an ellipse.
struct Disc {
  double along = 0, across = 0, mixed = 0;
};

/// With the zenith so far from the top of the picture, anticlockwise.
Disc disc_in(const texture::Image& frame, double zenith_rad) {
  const glm::dvec2 zenith{-std::sin(zenith_rad), -std::cos(zenith_rad)};
  Disc disc;
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      if (frame(r, c, 0) == 0) continue;
      const glm::dvec2 place{static_cast<double>(c) + 0.5 - side / 2.,
                             static_cast<double>(r) + 0.5 - side / 2.};
      const double z = glm::dot(place, zenith), h = place.x * zenith.y - place.y * zenith.x;
      disc.along += z * z, disc.across += h * h, disc.mixed += z * h;
    }
  return disc;
}

class LowMoon : public ProgramTest {
 protected:
  texture::Image frame_of(const std::string& folder, Words more) const {
    Words words{"scene",           instant,   "--at",    at,     "--rays",       "50",
                "--texture-width", "64",      "--width", "360",  "--height",     "360",
                "--field",         "0.6",     "-o",      folder, "--albedo-map", "built-in",
                "--atmosphere",    "undated", "--sky",   "off"};
    words += more;
    expect_done(coppermoon(words));
    return texture::read_image(povray_scenes::render(here(folder)));
  }
};

TEST_F(LowMoon, IsAsFlatAsPublishedRefractionMakesIt) {
  const auto view = seen();
  const double altitude_deg = in_degrees(view.altitude);
  ASSERT_TRUE(altitude_deg > 1 && altitude_deg < 3) << altitude_deg;
  const double radius_deg =
      std::asin(almanac::lunar_radius / view.moon_distance) * 180 / std::numbers::pi;
  const double flattening = (apparent_altitude_deg(altitude_deg + radius_deg) -
                             apparent_altitude_deg(altitude_deg - radius_deg)) /
                            (2 * radius_deg);
  const auto disc = disc_in(frame_of("zenith", "--up zenith --atmosphere standard"), 0);
  EXPECT_WITHIN(std::sqrt(disc.along / disc.across), flattening, 0.005,
                "two published formulae, and pixels of 1/300 of the disc");
  EXPECT_LT(flattening, 0.95) << "or there was nothing to see";
}

TEST_F(LowMoon, IsFlattenedTowardsTheZenithWithNorthUp) {
  // East is left of north: the parallactic angle is anticlockwise in the picture.
  const double zenith_rad = in_radians(seen().parallactic_angle);
  ASSERT_GT(std::abs(std::sin(2 * zenith_rad)), 0.5) << "or up and down could not be told apart";
  const auto disc = disc_in(frame_of("north", "--up celestial-north"), zenith_rad);
  EXPECT_LT(disc.along, 0.9 * disc.across);
  EXPECT_WITHIN(disc.mixed / disc.across, 0, 0.002, "whole pixels at the limb");
}

TEST_F(LowMoon, KeepsItsTexture) {
  const auto flat = frame_of("flat", {});
  const auto round = frame_of("round", "--flattening off");
  const double zenith_rad = in_radians(seen().parallactic_angle);
  const auto disc = disc_in(round, zenith_rad);
  EXPECT_WITHIN(disc.along / disc.across, 1, 0.002, "whole pixels at the limb");
  EXPECT_LT(disc_in(flat, zenith_rad).along, 0.95 * disc.along);
  const auto texels = [&](const char* folder) {
    return texture::read_image(here(folder) / "moon_lin_rec709.exr").values;
  };
  EXPECT_EQ(texels("flat"), texels("round"));
}

}  // namespace coppermoon::end_to_end::low_moon_test
