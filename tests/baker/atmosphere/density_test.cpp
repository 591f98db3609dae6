// SPDX-License-Identifier: MIT
#include "atmosphere/density.h"

#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::atmosphere::density_test {

const auto levels = published_table("baker/atmosphere/data/us_standard_1976_levels.csv");

TEST(DensityRatioUs1976, IsThatOfTheStandardToItsDigits) {
  const auto &altitude = levels["altitude_km"], &density = levels["number_density_per_m3"];
  for (std::size_t i = 0; i < altitude.size(); ++i)
    EXPECT_WITHIN_RELATIVE(density_ratio_us_1976(altitude[i] * 1e3), density[i] / density[0], 1e-5,
                           "6 digits, in both the value and that at sea level")
        << altitude[i] << " km";
}

TEST(DensityRatioUs1976, IsThatOfAnIndependentCode) {
  const auto &altitude = levels["altitude_km"], &pdas = levels["density_ratio_pdas"];
  for (std::size_t i = 0; i < altitude.size(); ++i) {
    const double tolerance = altitude[i] <= 50 ? 1e-4 : 4e-4;
    EXPECT_WITHIN_RELATIVE(density_ratio_us_1976(altitude[i] * 1e3), pdas[i], tolerance,
                           "another Earth radius: 0.3 km/10⁴ of the altitude, growing with it")
        << altitude[i] << " km";
  }
}

TEST(DensityRatioUs1976, HasTheFiguresItsDocumentationStates) {
  EXPECT_EQ(density_ratio_us_1976(0), 1);
  EXPECT_WITHIN(density_ratio_us_1976(42e3), 2.44e-3, 5e-6, "stated to 3 digits");
}

// U.S. Standard Atmosphere 1976, table I: 1.3470 kg/m³ at −1 km, 1.2250 at 0.
TEST(DensityRatioUs1976, GoesOnBelowSeaLevel) {
  EXPECT_WITHIN(density_ratio_us_1976(-1000), 1.3470 / 1.2250, 1e-4, "printed to 5 digits");
}

TEST(DensityRatioUs1976, EndsAt86Kilometres) {
  EXPECT_GT(density_ratio_us_1976(85.9e3), 0);
  EXPECT_EQ(density_ratio_us_1976(86.1e3), 0);
  EXPECT_EQ(density_ratio_us_1976(1e9), 0);
}

// dp = −ρ g dh with g = g₀ (r₀/(r₀ + h))²: the air below 38 km weighs what pressure falls by.
TEST(DensityRatioUs1976, WeighsWhatThePressureFallsBy) {
  constexpr double r0 = 6356766, step_m = 1;
  double weight = 0;
  for (double h = step_m / 2; h < 38e3; h += step_m)
    weight += density_ratio_us_1976(h) * 1.2250 * 9.80665 * std::pow(r0 / (r0 + h), 2) * step_m;
  const auto at_38_km = levels["pressure_Pa"][19];
  ASSERT_EQ(levels["altitude_km"][19], 38);
  EXPECT_WITHIN_RELATIVE(weight, 101325 - at_38_km, 2e-5, "1.2250 kg/m³ is printed to 5 digits");
}

TEST(DensityRatioYapoCutler, IsUs1976UpTo39Kilometres) {
  for (double h = -5e3; h <= 39e3; h += 500)
    EXPECT_EQ(density_ratio_yapo_cutler(h), density_ratio_us_1976(h));
}

TEST(DensityRatioYapoCutler, FallsAlongARampToNothingAt42Kilometres) {
  EXPECT_WITHIN(density_ratio_yapo_cutler(40.5e3), density_ratio_us_1976(40.5e3) / 2, 1e-16,
                "half way down the ramp");
  EXPECT_WITHIN(density_ratio_yapo_cutler(41e3), density_ratio_us_1976(41e3) / 3, 1e-16,
                "two thirds down the ramp");
  EXPECT_EQ(density_ratio_yapo_cutler(42e3), 0);
  EXPECT_EQ(density_ratio_yapo_cutler(50e3), 0);
}

template <class Function, class WithSlope>
void expect_slope(Function density, WithSlope with_slope, double altitude_m) {
  const auto analytic = with_slope(altitude_m);
  EXPECT_WITHIN_RELATIVE(analytic.value, density(altitude_m), 1e-14, "rounding");
  const double difference = (density(altitude_m + 5) - density(altitude_m - 5)) / 10;
  EXPECT_WITHIN_RELATIVE(analytic.slope_per_m, difference, 1e-6,
                         "a centred difference of 10 m errs by h²/6 of the third derivative")
      << altitude_m << " m";
}

TEST(DensitySlope, IsTheDerivativeOfTheDensity) {
  for (double h = -2e3 + 17; h < 85e3; h += 533)
    expect_slope(density_ratio_us_1976, density_ratio_and_slope_us_1976, h);
  for (double h = -2e3 + 17; h < 41.9e3; h += 533)
    expect_slope(density_ratio_yapo_cutler, density_ratio_and_slope_yapo_cutler, h);
}

TEST(DensitySlope, IsNothingAboveTheAir) {
  EXPECT_EQ(density_ratio_and_slope_us_1976(90e3).slope_per_m, 0);
  EXPECT_EQ(density_ratio_and_slope_yapo_cutler(42e3).slope_per_m, 0);
}

double slope(double altitude_m) {
  return density_ratio_and_slope_yapo_cutler(altitude_m).slope_per_m;
}

bool near_a_break(double altitude_m) {
  return std::ranges::any_of(density_breaks_m(),
                             [&](double h) { return std::abs(altitude_m - h) < 20; });
}

// Layers meet at 11, 20 and 32 km of geopotential: H r₀ / (r₀ − H) of geometric altitude.
// Layers meet at these geopotentials H [km], at geometric altitudes H r₀ / (r₀ − H).
TEST(DensityBreaksUs1976, AreTheTopsOfTheLayersOfTheStandard) {
  const auto breaks = density_breaks_us_1976_m();
  constexpr std::array geopotential_m{11e3, 20e3, 32e3, 47e3, 51e3, 71e3, 84852.0};
  ASSERT_EQ(breaks.size(), geopotential_m.size());
  for (std::size_t i = 0; i < breaks.size(); ++i)
    EXPECT_WITHIN(breaks[i], geopotential_m[i] * 6356766 / (6356766 - geopotential_m[i]), 1e-9,
                  "rounding");
  EXPECT_WITHIN(breaks.back(), 86e3, 0.5, "86 km, rounded to 1 m of geopotential");
}

TEST(DensityBreaksUs1976, AreWhereTheSlopeJumpsAndNowhereElse) {
  const auto jump = [](double h) {
    return density_ratio_and_slope_us_1976(h + 1).slope_per_m /
               density_ratio_and_slope_us_1976(h - 1).slope_per_m -
           1;
  };
  const auto breaks = density_breaks_us_1976_m();
  for (const double h : breaks) EXPECT_GT(std::abs(jump(h)), 0.01) << h << " m";
  for (double h = 5; h < 85.95e3; h += 10)
    if (std::ranges::none_of(breaks, [h](double b) { return std::abs(h - b) < 20; })) {
      EXPECT_WITHIN(jump(h), 0.0, 0.003, "2 m of a scale height of 1 to 8 km") << h << " m";
    }
}

TEST(DensityBreaks, AreTheLayersOfTheStandardAndTheRamp) {
  const auto breaks = density_breaks_m();
  ASSERT_EQ(breaks.size(), 5u);
  EXPECT_WITHIN(breaks[0], 11019.07, 0.01, "rounded to 1 cm");
  EXPECT_WITHIN(breaks[1], 20063.12, 0.01, "rounded to 1 cm");
  EXPECT_WITHIN(breaks[2], 32161.91, 0.01, "rounded to 1 cm");
  EXPECT_EQ(breaks[3], 39e3);
  EXPECT_EQ(breaks[4], 42e3);
}

TEST(DensityBreaks, AreWhereTheSlopeJumpsAndNowhereElse) {
  for (const double h : density_breaks_m())
    EXPECT_GT(std::abs(slope(h + 1) / slope(h - 1) - 1), 0.01) << h << " m";
  for (double h = 5; h < 41.95e3; h += 10)
    if (!near_a_break(h)) {
      EXPECT_WITHIN(slope(h + 1) / slope(h - 1), 1.0, 0.003, "2 m of a scale height of 1 to 8 km");
    }
}

}  // namespace coppermoon::atmosphere::density_test
