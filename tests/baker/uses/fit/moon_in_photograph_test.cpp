// SPDX-License-Identifier: MIT
#include "uses/fit/moon_in_photograph.h"

#include "almanac/instant.h"
#include "colour/glow.h"
#include "colour/picture_part.h"
#include "support/testing.h"

namespace coppermoon::uses::moon_in_photograph_test {

constexpr double pixel_km = 2 * 1737.4 / (fit_disc_share * fit_side_px);

FitScene eclipsed() {
  FitScene scene;
  scene.sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T20:20:00Z"));
  scene.disc = {fit_side_px / 2., fit_side_px / 2., 100};
  return scene;
}

/// A Moon of half the scene's size, whose limb is some pixels of the photograph beside where its markings are.
colour::Registration registered(double beside_px) {
  const double middle = fit_side_px / 4.;
  return {{.scale = 0.5}, 0.99, {middle + beside_px, middle, 50}};
}

TEST(Photograph, LimbErrsByAThirdOfAPixelBesideTheMarkings) {
  EXPECT_EQ(off_limb_km(eclipsed(), registered(0.3)), 0);
  EXPECT_WITHIN_RELATIVE(off_limb_km(eclipsed(), registered(3.3)), 3 * 2 * pixel_km, 1e-9,
                         "rounding");
}

TEST(Photograph, PlaceIsBelievedLessWhereLimbAndMarkingsDisagree) {
  const double agreed = place_error_km(eclipsed(), registered(0), false),
               in_its_air = place_error_km(eclipsed(), registered(0), true);
  EXPECT_WITHIN_RELATIVE(agreed, std::hypot(0.3, 0.02) * 2 * pixel_km, 1e-9, "rounding");
  EXPECT_WITHIN_RELATIVE(in_its_air, std::hypot(0.2, 0.02) * 2 * pixel_km, 1e-9, "rounding");
  EXPECT_WITHIN_RELATIVE(place_error_km(eclipsed(), registered(2.3), true),
                         std::hypot(in_its_air, 2 * 2 * pixel_km), 1e-9, "rounding");
}

/// A small Moon whose crescent is 30 times too bright for the sensor, in the glow that this makes.
TEST(Photograph, IsRegisteredInItsGlow) {
  constexpr std::size_t side = 170;
  constexpr double scale = 0.34, share = 0.02, overexposed = 30;
  const auto sky = almanac::sky_at(almanac::instant_from_utc("2018-07-27T19:04:28Z"));
  MoonRequest request;
  request.texture_width = 512;
  auto scene = fit_scene(request, groundwork_of(request, std::span(&sky, 1)), {}, sky);
  scene.glow = glow_of(scene);
  const auto seen = colour::with_glow(scene.moon, share, scene.pixel_rad);
  const double off = (side - scale * fit_side_px) / 2;
  texture::Image photo(side, side, {"R", "G", "B"});
  const double brightest = *std::ranges::max_element(scene.usual.values());
  for (std::size_t k = 0; k < 3; ++k) {
    algebra::Grid<float> channel(fit_side_px, fit_side_px);
    for (std::size_t i = 0; i < channel.values().size(); ++i)
      channel.values()[i] = static_cast<float>(overexposed / brightest * seen.values()[i][k]);
    const auto small = colour::resampled(channel, {scale, 0, off, off}, side, side);
    for (std::size_t r = 0; r < side; ++r)
      for (std::size_t c = 0; c < side; ++c) photo(r, c, k) = std::min(1.F, small(r, c));
  }
  const auto found = registration_of(scene, moon_part(photo));
  EXPECT_GT(found.correlation, 0.97);
  EXPECT_WITHIN_RELATIVE(found.render_to_photo.scale, scale, 0.04,
                         "a pixel and a half by which the glow widens the clipped limb");
}

}  // namespace coppermoon::uses::moon_in_photograph_test
