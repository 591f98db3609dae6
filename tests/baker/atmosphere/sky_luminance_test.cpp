// SPDX-License-Identifier: MIT
#include "atmosphere/sky_luminance.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::sky_luminance_test {

using algebra::degrees;

TEST(SkyLuminance, OfTheSunsOwnMagnitudeIsTheSuns) {
  // V = -26.76 over 6.79e-5 sr is 1.28e5 lx: 2.89 million square arc seconds. A sky is never so bright:
  // seen through a filter of 12.5 magnitudes, 1e-5 of its light
  const double sun_arcsec2 = 6.794e-5 / 2.3504e-11;
  EXPECT_WITHIN_RELATIVE(
      luminance_of_magnitude_cd_m2(-26.76 + 12.5 + 2.5 * std::log10(sun_arcsec2)) * 6.794e-5, 1.28,
      0.03, "of the magnitude's zero point in the literature");
}

TEST(SkyLuminance, RefusesWhatIsNoSky) {
  EXPECT_GT(luminance_of_magnitude_cd_m2(30), 0);
  EXPECT_THROW(luminance_of_magnitude_cd_m2(30.1), algebra::Error);
}

double magnitude_of(double cd_m2) {
  return -2.5 * std::log10(cd_m2 / luminance_of_magnitude_cd_m2(0));
}

constexpr double dark = 21.9,
                 full_moon = -12.73;  // V; the Moon's as in Krisciunas & Schaefer (1991), eq. 9

/// Sky at the zenith.
SkyDirection zenith(double from_lamp_deg) { return {degrees(90), degrees(from_lamp_deg)}; }

TEST(MoonlitSky, IsThatOfAnIndependentProgram) {
  // specsim (DESI), krisciunas_schaefer(20 deg, 70 deg, 50 deg, 0.25, 0.15) = 19.855 mag/arcsec2: the sky 20 degrees from
  // the zenith, the Moon 70 from it and 50 from the sky, 45 degrees of phase, k = 0.15
  const double moon = full_moon + 0.026 * 45 + 4e-9 * std::pow(45, 4);
  EXPECT_WITHIN(
      magnitude_of(moonlit_sky_cd_m2({moon, degrees(20)}, {degrees(70), degrees(50)}, 0.15)),
      19.855, 0.01, "mag; the zero point of magnitudes, 1.084e5 there");
}

TEST(MoonlitSky, IsThatOfParanalWithinTheFormulasAccuracy) {
  // ESO SkyCalc 1.4.3 (Noll et al. 2012, Jones et al. 2013), Cerro Paranal: zenith, full Moon at 45 degrees, V = 18.01
  // mag/arcsec2; moonless V = 21.83
  EXPECT_WITHIN(magnitude_of(airglow_cd_m2(degrees(90), 0.13)), 21.83, 0.1, "mag: SkyCalc");
  const double surge =
      -0.25;  // at 0 degrees of phase, beyond eq. 9: Buratti et al. (1996) have 0.2 to 0.4
  const double sky = airglow_cd_m2(degrees(90), 0.13) +
                     moonlit_sky_cd_m2({full_moon + surge, degrees(45)}, zenith(45), 0.13);
  EXPECT_WITHIN(magnitude_of(sky), 18.01, 0.3, "mag: the formula's 23 %");
}

TEST(MoonlitSky, IsASmallPartOfTheLightThatTheAirTakesFromTheBeam) {
  const double k = 0.25;
  for (const double altitude : {20., 45., 70.}) {
    constexpr int rows = 90, columns = 180;
    constexpr double step = std::numbers::pi / 2 / rows;
    const double moon = altitude * std::numbers::pi / 180;
    double lx = 0;
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        const double a = (r + 0.5) * step, b = (c + 0.5) * 2 * std::numbers::pi / columns;
        const double cosine =
            std::sin(a) * std::sin(moon) + std::cos(a) * std::cos(moon) * std::cos(b);
        lx += moonlit_sky_cd_m2({full_moon, degrees(altitude)},
                                {algebra::radians(a), algebra::radians(std::acos(cosine))}, k) *
              std::sin(a) * std::cos(a) * step * 2 * std::numbers::pi / columns;
      }
    const double above = 2.54e-6 * std::pow(10, -0.4 * full_moon) * std::sin(moon);  // Allen: V = 0
    const double taken = above * (1 - std::pow(10, -0.4 * k * sky_air_mass(degrees(altitude))));
    EXPECT_GT(lx, 0.3 * taken) << altitude << ": air scatters half of it down, and absorbs little";
    EXPECT_LT(lx, 0.7 * taken) << altitude;
  }
}

TEST(MoonlitSky, RisesWithTheMoon) {
  const auto at = [](double altitude, double magnitude = full_moon) {
    return moonlit_sky_cd_m2({magnitude, degrees(altitude)}, zenith(90 - altitude), 0.25);
  };
  EXPECT_EQ(at(-1), 0);
  EXPECT_EQ(at(45, std::numeric_limits<double>::infinity()), 0) << "a dark Moon";
  EXPECT_LT(at(-0.29), 0.02 * at(0.31)) << "no step in a film";
  EXPECT_WITHIN(at(45, full_moon + 10) * 1e4, at(45), 1e-9, "ten magnitudes are 1e4");
  for (const double rho : {0., 0.1, 5., 8., 9., 60., 180.})
    EXPECT_TRUE(std::isfinite(
        moonlit_sky_cd_m2({full_moon, degrees(45)}, {degrees(0), degrees(rho)}, 0.25)));
}

TEST(MoonlitSky, HasNoRimAroundTheMoon) {
  const auto slope = [](double rho) {
    return std::log(scattering_terms(degrees(rho + 0.1)).aerosol /
                    scattering_terms(degrees(rho)).aerosol) /
           0.1;
  };
  for (double rho = 0; rho < 20; rho += 0.1)
    EXPECT_LT(std::abs(slope(rho + 0.1) - slope(rho)), 0.21)
        << rho << ": of the logarithm by degree, 0.2 of 1 / (1 + rho^2) about the Moon's limb";
}

TEST(MoonlitSky, HasNoStepNearTheMoon) {
  for (double rho = 1; rho < 20; rho += 0.1) {
    const auto near = scattering_terms(degrees(rho)), far = scattering_terms(degrees(rho + 0.1));
    EXPECT_LE(far.aerosol, near.aerosol) << rho;
    EXPECT_GT(far.aerosol, 0.8 * near.aerosol) << rho;
  }
}

TEST(Airglow, GrowsTowardsTheHorizonAsInTheFormula) {
  const double k = 0.25;
  const auto brighter_mag = [&](double altitude) {
    return dark - magnitude_of(airglow_cd_m2(degrees(altitude), k));
  };
  EXPECT_WITHIN_RELATIVE(airglow_cd_m2(degrees(90), k), luminance_of_magnitude_cd_m2(dark), 1e-12,
                         "closed form");
  EXPECT_WITHIN(sky_air_mass(degrees(0)), 5, 1e-9, "closed form: 1 / sqrt(0.04)");
  EXPECT_WITHIN(brighter_mag(0), 2.5 * std::log10(5) - 4 * k, 1e-9, "closed form");
  EXPECT_GT(brighter_mag(10), brighter_mag(30));
  EXPECT_EQ(sky_air_mass(degrees(-20)), sky_air_mass(degrees(0)));
}

TEST(VisualExtinction, IsThatOfTheDepths) {
  const ObserverAir air{.elevation_m = 1000};
  const double altitude_mag =
      -2.5 * std::log10(transmittance_above(air, degrees(90), algebra::nanometres(550)));
  EXPECT_WITHIN(visual_extinction_mag(air), altitude_mag, 1e-3, "air masses of the zenith: 1.0000");
  EXPECT_GT(visual_extinction_mag({}), visual_extinction_mag(air));
}

}  // namespace coppermoon::atmosphere::sky_luminance_test
