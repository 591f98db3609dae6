// SPDX-License-Identifier: MIT
#include "photons/solar_disc.h"

#include "algebra/interpolation.h"
#include "baker/algebra/chi_squared.h"
#include "baker/atmosphere/published_table.h"
#include "support/testing.h"

namespace coppermoon::photons::solar_disc_test {

std::vector<double> edges(int bands) {
  std::vector<double> nm;
  for (int i = 0; i <= bands; ++i) nm.push_back(380 + 400.0 * i / bands);
  return nm;
}

double total(int bands) {
  double sum = 0;
  for (const double e : solar_irradiance(edges(bands))) sum += e * 400 / bands;
  return sum;
}

// Trapezia over the published standard from 380 to 780 nm: 654.94 W/m². Wehrli (1985) has 655.58.
TEST(SolarIrradiance, HasTheTotalOfTheStandard) {
  EXPECT_WITHIN(total(1), 654.94, 0.01, "rounded to 0.01");
  EXPECT_WITHIN_RELATIVE(total(1), 655.58, 0.002, "another measured spectrum");
}

// 683 lm/W ∫ E V dλ over the published standard: 133 319 lx.
TEST(SolarIrradiance, HasTheIlluminanceOfTheStandard) {
  const auto v = published_table("baker/photons/data/photopic_efficiency.csv");
  const auto nm = edges(400);
  const auto irradiance = solar_irradiance(nm);
  double lux = 0;
  for (std::size_t i = 0; i < irradiance.size(); ++i)
    lux +=
        683 * irradiance[i] * algebra::interpolated(v["wavelength_nm"], v["photopic"], nm[i] + 0.5);
  EXPECT_WITHIN_RELATIVE(lux, 133319.0, 1e-3, "V(λ) every 5 nm, straight between");
}

TEST(SolarIrradiance, OfBandsAddsUpToThatOfTheWhole) {
  for (const int bands : {7, 40, 200, 1000})
    EXPECT_WITHIN_RELATIVE(total(bands), total(1), 1e-12, "rounding") << bands;
}

TEST(SolarIrradiance, RefusesBandsOutsideItsRangeOrFolded) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& nm :
       {std::array{378.9, 400.0}, std::array{700.0, 781.1}, std::array{500.0, 400.0},
        std::array{400.0, 400.0}, std::array{400.0, nan}})
    EXPECT_THROW(solar_irradiance(nm), algebra::Error) << nm[0] << " to " << nm[1];
  EXPECT_NO_THROW(solar_irradiance(std::array{379.0, 781.0}));
}

TEST(RandomPlaceOnDisc, IsUniformOverTheDisc) {
  algebra::Random random(1, 1);
  std::array<int, 100> seen{};
  for (int i = 0; i < 1'000'000; ++i) {
    const auto place = random_place_on_disc(random);
    const double r_squared = place.x * place.x + place.y * place.y;
    ASSERT_LE(r_squared, 1);
    const double turn = std::atan2(place.y, place.x) / (2 * std::numbers::pi) + 0.5;
    ++seen[10 * static_cast<std::size_t>(std::min(r_squared * 10, 9.5)) +
           static_cast<std::size_t>(std::min(turn * 10, 9.5))];
  }
  EXPECT_UNIFORM(seen, chi_squared_of_99);
}

TEST(RandomPlaceOnDisc, HasItsMeanAtTheCentreAndAQuarterForItsSquares) {
  algebra::Random random(2, 1);
  constexpr int count = 1'000'000;
  double x = 0, y = 0, x_squared = 0;
  for (int i = 0; i < count; ++i) {
    const auto place = random_place_on_disc(random);
    x += place.x / count;
    y += place.y / count;
    x_squared += place.x * place.x / count;
  }
  constexpr auto reason = "one run in 1000 exceeds it";
  EXPECT_WITHIN(x, 0.0, 3.3 * std::sqrt(0.25 / count), reason);
  EXPECT_WITHIN(y, 0.0, 3.3 * std::sqrt(0.25 / count), reason);
  EXPECT_WITHIN(x_squared, 0.25, 3.3 * std::sqrt((0.125 - 0.0625) / count), reason);
}

}  // namespace coppermoon::photons::solar_disc_test
