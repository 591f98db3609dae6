// SPDX-License-Identifier: MIT
#include "eclipse/shadow_cone.h"

#include "atmosphere/figure.h"
#include "support/testing.h"

namespace coppermoon::eclipse::shadow_cone_test {

using algebra::degrees;
using algebra::in_arcminutes;
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

TEST(ShadowRadii, AreDistancesFromTheAxis) {
  // 5000 km off the axis of a Moon whose distance is 384400 km: asin(5000 / 384400) = 44.71701′
  const ShadowPlace moon{algebra::kilometres(3000), radians(0),
                         algebra::kilometres(std::sqrt(384400. * 384400. - 3000. * 3000.))};
  EXPECT_WITHIN(algebra::in_kilometres(axis_distance_at(degrees(44.71701 / 60), moon)), 5000, 0.01,
                "printed digits");
}

TEST(ShadowRadii, DanjonsOblateAreFlattenedByTheLimb) {
  const auto radii = [](double position_angle_deg) {
    return shadow_radii(ShadowConvention::danjon_oblate, axis,
                        moon_at(degrees(position_angle_deg)));
  };
  const double equatorial = 1.0117647 * lunar_parallax_arcmin, flattening = 1 / 298.257;
  const double unenlarged = solar_parallax_arcmin - solar_semidiameter_arcmin;
  const char* reason = "the formula by hand, 1 + 1/85 = 1.0117647; second order in f is 3e-4′";
  EXPECT_WITHIN(in_arcminutes(radii(90).umbra), equatorial + unenlarged, 1e-3, reason);
  EXPECT_WITHIN(in_arcminutes(radii(180).umbra), equatorial * (1 - flattening) + unenlarged, 1e-3,
                reason);
  EXPECT_WITHIN(in_arcminutes(radii(45).umbra), equatorial * (1 - flattening / 2) + unenlarged,
                1e-3, reason);
  EXPECT_WITHIN(in_arcminutes(radii(45).penumbra) - in_arcminutes(radii(45).umbra),
                2 * solar_semidiameter_arcmin, 1e-3, "s is not enlarged");
}

TEST(ShadowRadii, DanjonsOblateAreTippedWithTheEarth) {
  ShadowAxis tipped = axis;
  tipped.sun_declination = degrees(23.44);
  const auto umbra = [&](const ShadowAxis& a) {
    return in_arcminutes(
        shadow_radii(ShadowConvention::danjon_oblate, a, moon_at(degrees(0))).umbra);
  };
  EXPECT_WITHIN(umbra(tipped) - umbra(axis), 1.0117647 * lunar_parallax_arcmin / 298.257 * 0.15824,
                1e-3, "f sin² 23.44° of the parallax, to first order in f");
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
                parallaxes * atmosphere::earth_flattening, 1e-3,
                "a polar radius smaller by the flattening");
}

TEST(ShadowRadii, AllConventionsAgreeToAHundredthOfTheUmbra) {
  const auto danjon = shadow_radii(ShadowConvention::danjon, axis, moon_at(degrees(45)));
  for (auto other : {ShadowConvention::danjon_oblate, ShadowConvention::chauvenet,
                     ShadowConvention::herald_sinnott})
    EXPECT_WITHIN_RELATIVE(in_arcminutes(shadow_radii(other, axis, moon_at(degrees(45))).umbra),
                           in_arcminutes(danjon.umbra), 0.01,
                           "published magnitudes differ by 0.005 of the Moon's diameter: 0.4 %");
}

TEST(LunarSemidiameter, IsThirtyOneArcminutesAcrossAtTheMeanDistance) {
  EXPECT_WITHIN(2 * in_arcminutes(lunar_semidiameter(moon_at(degrees(0)))), 31.088, 0.01,
                "2 × 932.6″ at 384 400 km (k = 0.2725), given to 0.1″");
}

}  // namespace coppermoon::eclipse::shadow_cone_test
