// SPDX-License-Identifier: MIT
#include "eclipse/shadow_cone.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/within.h"

namespace coppermoon::eclipse {
namespace {

using algebra::degrees;
using algebra::in_arcminutes;
using algebra::in_metres;
using algebra::radians;

/// One astronomical unit to the Sun, which stands on the equator.
const ShadowAxis axis{glm::dmat3(1), algebra::metres(1.495978707e11), radians(0)};

ShadowPlace moon_at(algebra::Angle position_angle) {
  return {algebra::metres(0), position_angle, algebra::kilometres(384400)};
}

const double lunar_parallax_arcmin = 57.0432;  // asin(6378.137 / 384400)
const double solar_parallax_arcmin = 8.794148 / 60, solar_semidiameter_arcmin = 959.63 / 60;

TEST(ShadowRadii, DanjonsAreAHundredthOfTheLunarParallaxLarger) {
  const auto radii = shadow_radii(ShadowConvention::danjon, axis, moon_at(degrees(0)));
  EXPECT_WITHIN(in_arcminutes(radii.umbra),
                1.01 * lunar_parallax_arcmin + solar_parallax_arcmin - solar_semidiameter_arcmin,
                1e-3, "the formula by hand, the parallax to 0.0001′");
  EXPECT_WITHIN(in_arcminutes(radii.penumbra),
                1.01 * lunar_parallax_arcmin + solar_parallax_arcmin + solar_semidiameter_arcmin,
                1e-3, "the same");
}

TEST(ShadowRadii, ChauvenetsAreAFiftiethLargerThanAMeanEarths) {
  const auto radii = shadow_radii(ShadowConvention::chauvenet, axis, moon_at(degrees(0)));
  const double mean = 0.998340 * lunar_parallax_arcmin + solar_parallax_arcmin;
  EXPECT_WITHIN(in_arcminutes(radii.umbra), 1.02 * (mean - solar_semidiameter_arcmin), 1e-3,
                "the formula by hand");
  EXPECT_WITHIN(in_arcminutes(radii.penumbra), 1.02 * (mean + solar_semidiameter_arcmin), 1e-3,
                "the formula by hand");
}

TEST(ShadowRadii, HeraldAndSinnottsUmbraIsFlattened) {
  const auto east = shadow_radii(ShadowConvention::herald_sinnott, axis, moon_at(degrees(90)));
  const auto north = shadow_radii(ShadowConvention::herald_sinnott, axis, moon_at(degrees(0)));
  const double parallaxes = lunar_parallax_arcmin + solar_parallax_arcmin;
  EXPECT_WITHIN(in_arcminutes(east.umbra) + solar_semidiameter_arcmin,
                parallaxes * (1 + 87 / 6378.137), 1e-3,
                "87 km of opaque air on the equatorial radius, by hand");
  EXPECT_WITHIN(in_arcminutes(east.umbra) - in_arcminutes(north.umbra),
                parallaxes * earth_flattening, 1e-3, "a polar radius smaller by the flattening");
}

TEST(ShadowRadii, AllThreeConventionsAgreeToAHundredthOfTheUmbra) {
  const auto danjon = shadow_radii(ShadowConvention::danjon, axis, moon_at(degrees(45)));
  for (auto other : {ShadowConvention::chauvenet, ShadowConvention::herald_sinnott})
    EXPECT_WITHIN_RELATIVE(in_arcminutes(shadow_radii(other, axis, moon_at(degrees(45))).umbra),
                           in_arcminutes(danjon.umbra), 0.01,
                           "published magnitudes differ by 0.005 of the Moon's diameter: 0.4 %");
}

TEST(LunarSemidiameter, IsThirtyOneArcminutesAcrossAtTheMeanDistance) {
  EXPECT_WITHIN(2 * in_arcminutes(lunar_semidiameter(moon_at(degrees(0)))), 31.088, 0.01,
                "2 × 932.6″ at 384 400 km (k = 0.2725), given to 0.1″");
}

TEST(LimbRadius, RunsFromTheEquatorialToThePolarRadius) {
  EXPECT_WITHIN(in_metres(limb_radius(degrees(90), degrees(0))), 6378137, 1e-3, "definition");
  EXPECT_WITHIN(in_metres(limb_radius(degrees(0), degrees(0))), 6356752, 2,
                "WGS 84's polar radius; 1/298.257 is rounded");
}

TEST(LimbRadius, AtTheSolsticeThePoleIsTippedIn) {
  const double tipped = in_metres(limb_radius(degrees(0), degrees(23.44)));
  const double cosine = std::cos(23.44 * std::acos(-1.0) / 180);
  EXPECT_WITHIN(6378137 - tipped, (6378137 - 6356752) * cosine * cosine, 20,
                "to first order in the flattening; the second is 1/300 of 18 km");
}

}  // namespace
}  // namespace coppermoon::eclipse
