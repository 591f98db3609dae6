// SPDX-License-Identifier: MIT
#include "atmosphere/twilight_sky.h"

#include "atmosphere/sky_luminance.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::twilight_sky_test {

using algebra::degrees;
using std::numbers::pi;
using Light = std::array<double, 3>;

double luminance(const Light& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

/// u', v' of linear Rec.709 (IEC 61966-2-1).
std::pair<double, double> chromaticity(const Light& c) {
  const double x = 0.4124 * c[0] + 0.3576 * c[1] + 0.1805 * c[2],
               z = 0.0193 * c[0] + 0.1192 * c[1] + 0.9505 * c[2],
               sum = x + 15 * luminance(c) + 3 * z;
  return {4 * x / sum, 9 * luminance(c) / sum};
}

struct Seen {
  double altitude, aside, cd_m2, u, v;
};

TEST(TwilightSky, IsThatOfAForeignEngine) {
  // sasktran2 2026.10 (Zawada et al.), all orders: US 1976, 300 DU, aerosol of 0.1 with exponent 1.3, ground of albedo
  // 0.2, the Sun on the horizon. Below -2 degrees its successive orders give no reference: they weigh the narrow bright
  // arch by 110 directions of the whole sphere
  const TwilightSky sky(degrees(0), {});
  for (const auto& [altitude, aside, cd_m2, u, v] :
       {Seen{90, 0, 144, 0.181, 0.424}, Seen{10, 0, 1520, 0.233, 0.498},
        Seen{3, 0, 1870, 0.276, 0.523}, Seen{10, 180, 559, 0.198, 0.470},
        Seen{3, 180, 330, 0.214, 0.472}}) {
    const auto light = sky.towards(degrees(altitude), degrees(aside));
    EXPECT_WITHIN_RELATIVE(luminance(light), cd_m2, 0.25, "aerosol of other shape and height");
    EXPECT_WITHIN(chromaticity(light).first, u, 0.02, "as above");
    EXPECT_WITHIN(chromaticity(light).second, v, 0.02, "as above");
  }
}

TEST(TwilightSky, IsThatMeasuredInTheZenith) {
  // Patat, Ugolnikov & Postylyakov (2006), A&A 455, 385, table 5, Paranal, 2635 m, valid from 5 to 15 degrees:
  // V = 11.84 + 1.518 d - 0.057 d^2, d degrees below 5
  const ObserverAir paranal{.ozone_du = 260, .aerosol_optical_depth = 0.05, .elevation_m = 2635};
  for (double below = 5; below <= 14; below += 0.5) {
    const double d = below - 5, measured = 11.84 + 1.518 * d - 0.057 * d * d;
    const auto twilight = TwilightSky(degrees(-below), paranal).towards(degrees(90), {});
    const double sky = luminance(twilight) + airglow_cd_m2(degrees(90), 0.13);
    EXPECT_WITHIN(-2.5 * std::log10(sky / luminance_of_magnitude_cd_m2(0)), measured, 0.55,
                  "mag; their nights differ by 0.2, and the mesosphere's light is not in the table")
        << below;
  }
}

TEST(TwilightSky, LightsLevelGroundAsTheAlmanacHasIt) {
  // Explanatory Supplement (1992), section 9.331
  constexpr int rows = 90, columns = 180;
  constexpr double step = pi / 2 / rows, wide = 2 * pi / columns;
  for (const auto& [sun, lx] : {std::pair{-0.8, 453.}, {-6., 3.4}, {-12., 0.0081}}) {
    const TwilightSky sky(degrees(sun), {});
    double sum = 0;
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        const double a = (r + 0.5) * step;
        sum += luminance(sky.towards(algebra::radians(a), algebra::radians((c + 0.5) * wide))) *
               std::sin(a) * std::cos(a) * step * wide;
      }
    const double airglow = sun == -12. ? 6.5e-4 : 0;
    EXPECT_WITHIN_RELATIVE(sum + airglow, lx, 0.35, "the almanac's air is a mean one") << sun;
  }
}

/// Values of a channel along verticals, every 0.25 degrees.
std::vector<double> vertical(const TwilightSky& sky, double aside, std::size_t channel) {
  std::vector<double> values;
  for (double altitude = 0; altitude <= 90; altitude += 0.25)
    values.push_back(sky.towards(degrees(altitude), degrees(aside))[channel]);
  return values;
}

TEST(TwilightSky, HasOneMaximumAlongEveryVerticalAndNoKink) {
  constexpr double seen =
      1e-3;  // nobody sees a rise of less; a step of 8 bits is ten times as much
  for (double sun = 2; sun >= -18; sun -= 0.25) {
    const TwilightSky sky(degrees(sun), {});
    for (double aside = 0; aside <= 180; aside += 10)
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto values = vertical(sky, aside, channel);
        const auto greatest = std::ranges::max_element(values);
        EXPECT_TRUE(std::is_sorted(values.begin(), greatest,
                                   [](double a, double b) { return a < b * (1 - seen); }))
            << sun << " " << aside;
        EXPECT_TRUE(std::is_sorted(greatest, values.end(),
                                   [](double a, double b) { return a > b * (1 + seen); }))
            << sun << " " << aside;
        for (std::size_t i = 5; i + 1 < values.size(); ++i)
          EXPECT_LT(std::abs(values[i - 1] - 2 * values[i] + values[i + 1]), 0.02 * values[i])
              << sun << " " << aside << " " << 0.25 * double(i);
      }
  }
}

TEST(TwilightSky, ChangesWithoutAStepAsTheSunSinks) {
  for (const auto& [altitude, aside] : {std::pair{90., 0.}, {10., 0.}, {10., 90.}, {3., 180.}}) {
    std::vector<double> logarithms;
    for (double sun = 2; sun >= -18; sun -= 0.25)
      logarithms.push_back(std::log(
          luminance(TwilightSky(degrees(sun), {}).towards(degrees(altitude), degrees(aside)))));
    for (std::size_t i = 1; i + 1 < logarithms.size(); ++i) {
      EXPECT_LT(logarithms[i + 1], logarithms[i]);
      EXPECT_LT(std::abs(logarithms[i - 1] - 2 * logarithms[i] + logarithms[i + 1]), 0.05)
          << altitude << " " << aside << " " << 2 - 0.25 * double(i)
          << ": a fourth of the slope at most, 0.4 in a quarter of a degree";
    }
  }
}

TEST(TwilightSky, HasTheBeltOfVenus) {
  // Lee (2015), Applied Optics 54, B194: opposite the Sun, some degrees below the horizon, pink stands over the blue-grey
  // shadow of the Earth
  const TwilightSky sky(degrees(-3), {});
  const auto red_over_blue = [&](double altitude) {
    const auto light = sky.towards(degrees(altitude), degrees(180));
    return light[0] / light[2];
  };
  EXPECT_GT(red_over_blue(12), 1.2 * red_over_blue(3)) << "pink over blue-grey";
  EXPECT_GT(red_over_blue(12), 1.2 * red_over_blue(45)) << "blue above it";
}

TEST(TwilightSky, FollowsTheObserversAir) {
  const auto towards = [](const ObserverAir& air, double altitude, double aside) {
    return TwilightSky(degrees(-6), air).towards(degrees(altitude), degrees(aside));
  };
  const auto blue = [](const Light& light) { return light[2] / light[0]; };
  EXPECT_GT(blue(towards({.ozone_du = 400}, 90, 0)), blue(towards({}, 90, 0)))
      << "ozone makes the zenith of twilight blue (Hulburt 1953)";
  EXPECT_LT(luminance(towards({.elevation_m = 4000}, 90, 0)), luminance(towards({}, 90, 0)));
  EXPECT_LT(luminance(towards({.aerosol_optical_depth = 0.3}, 2, 0)),
            luminance(towards({.aerosol_optical_depth = 0.03}, 2, 0)))
      << "haze hides the arch";
  for (const double du : {0., 1000.})
    for (const double aerosol : {0., 10.})
      for (const double elevation : {-500., 1e5})
        for (const double sun : {-90., -18., 5.}) {
          const TwilightSky sky(
              degrees(sun),
              {.ozone_du = du, .aerosol_optical_depth = aerosol, .elevation_m = elevation});
          for (const double altitude : {-5., 0., 45., 90.})
            for (const double value : sky.towards(degrees(altitude), degrees(-170)))
              EXPECT_TRUE(std::isfinite(value) && value >= 0) << du << aerosol << elevation << sun;
        }
  EXPECT_THROW(TwilightSky(degrees(6), {}), algebra::Error);
}

}  // namespace coppermoon::atmosphere::twilight_sky_test
