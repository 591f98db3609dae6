// SPDX-License-Identifier: MIT
#include "uses/fit/moon_in_photograph.h"

#include "almanac/instant.h"
#include "support/testing.h"

namespace coppermoon::uses {
namespace {

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

}  // namespace
}  // namespace coppermoon::uses
