// SPDX-License-Identifier: MIT
#include "surface/photometry.h"

#include "algebra/random.h"
#include "algebra/table.h"
#include "support/testing.h"

namespace photometry_test {

using namespace coppermoon::surface;
using coppermoon::algebra::degrees;
using std::numbers::pi;

coppermoon::algebra::Table table(const std::string& name) {
  std::ifstream file(COPPERMOON_TEST_DATA "/baker/surface/data/" + name);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  return coppermoon::algebra::parse_table(text, name);
}

/// The reflectance of the whole disc of a uniform white Moon: 1/pi times the integral of f mu over
/// the sphere, in longitude and latitude from the place below the viewer, the Sun over longitude g.
double disc_reflectance(double g_deg) {
  constexpr int n = 400;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double latitude = pi * ((i + 0.5) / n - 0.5);
      const double longitude = g_deg * pi / 180 + (pi - g_deg * pi / 180) * (j + 0.5) / n - pi / 2;
      const double mu = std::cos(latitude) * std::cos(longitude);
      const double mu0 = std::cos(latitude) * std::cos(longitude - g_deg * pi / 180);
      sum += radiance_factor(Photometry::lommel_seeliger_rolo, mu0, mu, degrees(g_deg)) * mu *
             std::cos(latitude);
    }
  return sum * (pi / n) * ((pi - g_deg * pi / 180) / n) / pi;
}

TEST(YapoCutler, IsOneWhereLightFallsStraightDown) {
  EXPECT_WITHIN(radiance_factor_at_full_moon(Photometry::yapo_cutler, 1), 1, 1e-15,
                "1 / (0.1 + 0.9), but for rounding");
}

TEST(YapoCutler, FollowsItsEquation) {
  // 0.5 / 0.55 and 0.1 / 0.19: flat over most of the disc, half as bright only 6 degrees from the
  // limb.
  EXPECT_WITHIN(radiance_factor_at_full_moon(Photometry::yapo_cutler, 0.5), 0.9090909090909091,
                1e-15, "closed form");
  EXPECT_WITHIN(radiance_factor_at_full_moon(Photometry::yapo_cutler, 0.1), 0.5263157894736842,
                1e-15, "closed form");
}

TEST(YapoCutler, IsDarkOnTheNightSide) {
  EXPECT_EQ(radiance_factor_at_full_moon(Photometry::yapo_cutler, 0), 0);
  EXPECT_EQ(radiance_factor_at_full_moon(Photometry::yapo_cutler, -0.5), 0);
}

TEST(YapoCutler, HasTheDiscMeanOfItsClosedForm) {
  // 2 (1/(2b) − a/b² + a²/b³ ln((a + b)/a)), a = 0.1, b = 0.9.
  double sum = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double mu = (i + 0.5) / n;
    sum += 2 * mu * radiance_factor_at_full_moon(Photometry::yapo_cutler, mu) / n;
  }
  EXPECT_WITHIN(sum, 2 * (1 / 1.8 - 0.1 / 0.81 + 0.01 / 0.729 * std::log(10.)), 1e-9,
                "midpoint rule of 1e5 steps");
  EXPECT_WITHIN(sum, 0.92737, 5e-6, "the docstring's digits");
}

TEST(LommelSeeligerRolo, MakesTheDiscBrightenAsRoloMeasured) {
  const auto rolo = table("rolo_disc_reflectance.csv");
  const double nearest = disc_reflectance(1.55);
  for (const char* phase : {"3", "5", "7", "10"})
    for (std::size_t band = 0; band < 3; ++band)
      EXPECT_WITHIN_RELATIVE(disc_reflectance(std::stod(phase)) / nearest,
                             rolo[phase][band] / rolo["1.55"][band], 0.01,
                             "the docstring's; the bands differ from one another by 0.3 %");
}

TEST(LommelSeeligerRolo, SurgesByAQuarterFromFiveDegreesToOneAndAHalf) {
  EXPECT_WITHIN(disc_reflectance(1.55) / disc_reflectance(5), 1.245, 0.005,
                "ROLO at 549.1 nm, its reflectances rounded to three digits: 0.137 / 0.110");
  EXPECT_WITHIN(disc_reflectance(1.64) / disc_reflectance(5), 1.25, 0.025,
                "E. Schmidt, 11 January 2009: more than 1.25; two exposures to 1 % each");
}

TEST(LommelSeeligerRolo, FollowsAllensPhaseLawToTheQuarters) {
  const auto law = table("allen_phase_law.csv");
  for (std::size_t i = 0; i < law["phase_deg"].size(); ++i) {
    const double fainter =
        -2.5 * std::log10(disc_reflectance(law["phase_deg"][i]) / disc_reflectance(10));
    EXPECT_WITHIN(fainter, law["fainter_mag"][i] - law["fainter_mag"][0], 0.06,
                  "two instruments forty years apart; the docstring's");
  }
}

TEST(LommelSeeligerRolo, IsOneAllOverTheDiscAtFullMoon) {
  for (const double mu : {1., 0.7, 0.3, 0.01})
    EXPECT_WITHIN(radiance_factor(Photometry::lommel_seeliger_rolo, mu, mu, full_moon_phase), 1,
                  1e-15, "the law itself, but for rounding");
}

TEST(LommelSeeligerRolo, IsDarkOnTheNightSide) {
  EXPECT_EQ(radiance_factor(Photometry::lommel_seeliger_rolo, 0, 0, degrees(5)), 0);
  EXPECT_EQ(radiance_factor(Photometry::lommel_seeliger_rolo, -0.5, 1, degrees(120)), 0);
}

TEST(LommelSeeligerRolo, ReciprocatesBetweenSunAndViewer) {
  // Helmholtz: the reflected share per unit of projected area, f / mu0, stays when the two change
  // places.
  EXPECT_WITHIN(radiance_factor(Photometry::lommel_seeliger_rolo, 0.8, 0.3, degrees(40)) / 0.8,
                radiance_factor(Photometry::lommel_seeliger_rolo, 0.3, 0.8, degrees(40)) / 0.3,
                1e-15, "a law, but for rounding");
}

TEST(LommelSeeligerRolo, GoesOnToPhaseZeroAndIsHeldBeyondNinetySevenDegrees) {
  const auto at = [](double g) {
    return radiance_factor(Photometry::lommel_seeliger_rolo, 1, 1, degrees(g));
  };
  EXPECT_WITHIN(at(0), 1.157, 5e-4, "the docstring's digits");
  EXPECT_EQ(at(-1), at(0));
  EXPECT_GT(at(96), at(97));
  EXPECT_EQ(at(180), at(97));
}

TEST(LommelSeeligerRolo, IsFiniteAndNeverTooBright) {
  coppermoon::algebra::Random random(1, 1);
  const auto expect_sane = [](double mu0, double mu, double g_deg) {
    const double f = radiance_factor(Photometry::lommel_seeliger_rolo, mu0, mu, degrees(g_deg));
    EXPECT_TRUE(f >= 0 && f <= 2.32) << f << " for " << mu0 << ", " << mu << ", " << g_deg;
  };
  for (int i = 0; i < 100000; ++i)
    expect_sane(2 * random.uniform() - 1, 2 * random.uniform() - 1, 180 * random.uniform());
  for (const double mu0 : {-1., 0., 1e-300, 1.})
    for (const double mu : {-1., -1e-300, 0., 1e-300, 1.})
      for (const double g : {-1., 0., 1e-12, 90., 180., 360.}) expect_sane(mu0, mu, g);
}

TEST(RadianceFactor, IsThatOfTheFunctionChosen) {
  using enum Photometry;
  EXPECT_EQ(radiance_factor(yapo_cutler, 0.4, 0.6, degrees(30)),
            radiance_factor_at_full_moon(Photometry::yapo_cutler, 0.4));
  EXPECT_EQ(radiance_factor(lommel_seeliger_rolo, 0.4, 0.6, degrees(30)),
            radiance_factor(Photometry::lommel_seeliger_rolo, 0.4, 0.6, degrees(30)));
}

TEST(RadianceFactor, AtFullMoonIsThatOfItsPhase) {
  for (const auto photometry : {Photometry::yapo_cutler, Photometry::lommel_seeliger_rolo})
    for (const double mu : {-0.5, 0., 0.2, 1.})
      EXPECT_WITHIN(radiance_factor_at_full_moon(photometry, mu),
                    radiance_factor(photometry, mu, mu, full_moon_phase), 1e-15, "rounding");
}

}  // namespace photometry_test
