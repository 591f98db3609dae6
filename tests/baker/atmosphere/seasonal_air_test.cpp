// SPDX-License-Identifier: MIT
#include "atmosphere/seasonal_air.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::seasonal_air_test {

using algebra::degrees;

constexpr double mid_january = 2001 + 15 / 365.25, mid_july = mid_january + 0.5;

/// A model atmosphere of AFGL-TR-86-0110: pressures [hPa], printed beside the temperatures that the air
/// is made of, but not read by it.
struct Model {
  double latitude, year;
  std::array<double, 5> hpa;  ///< at 5, 10, 15, 20 and 30 km
};

TEST(SeasonalAir, WeighsWhatTheModelsPressuresSay) {
  const std::array models{Model{15, mid_january, {559, 286, 132, 56.5, 12.2}},
                          Model{45, mid_july, {554, 281, 130, 59.5, 13.2}},
                          Model{45, mid_january, {531.3, 256.8, 117.8, 53.7, 11.1}},
                          Model{60, mid_july, {541, 267.7, 126, 59, 13.4}},
                          Model{60, mid_january, {515.8, 241.8, 110.3, 50.14, 10.2}}};
  constexpr std::array<double, 5> heights_km{5, 10, 15, 20, 30};
  for (const auto& model : models) {
    const SeasonalAir air(degrees(model.latitude), model.year);
    for (std::size_t i = 0; i < heights_km.size(); ++i)
      EXPECT_WITHIN_RELATIVE(
          air.pressure_ratio(heights_km[i] * 1e3) * 1013.25, model.hpa[i], 0.02,
          "pressures are rounded to 3 digits, begin at 1010 to 1018 hPa, and are "
          "hydrostatic to 2 %")
          << model.latitude << " degrees, " << heights_km[i] << " km";
  }
}

TEST(SeasonalAir, IsAsDenseAsThePressureAndTemperatureMakeIt) {
  const SeasonalAir summer(degrees(60), mid_july), winter(degrees(60), mid_january);
  EXPECT_WITHIN_RELATIVE(summer.density_ratio(0).value, 288.15 / 287.2, 1e-12, "gas law");
  EXPECT_WITHIN_RELATIVE(winter.density_ratio(0).value, 288.15 / 257.2, 1e-12, "gas law");
  EXPECT_EQ(winter.density_ratio(86.1e3).value, 0);
}

TEST(SeasonalAir, HasTheSlopeOfItsDensity) {
  const SeasonalAir air(degrees(-35), 2001.3);
  for (double h = 0; h < 85e3; h += 777) {
    const auto here = air.density_ratio(h);
    const double difference = (air.density_ratio(h + 1).value - air.density_ratio(h - 1).value) / 2;
    EXPECT_WITHIN_RELATIVE(here.slope_per_m, difference, 1e-6,
                           "third derivatives of a metre's step")
        << h;
  }
}

TEST(SeasonalAir, OfTheSouthIsThatOfTheNorthHalfAYearLater) {
  const SeasonalAir north(degrees(50), 2001.3), south(degrees(-50), 2001.8);
  for (const double h : {0., 8e3, 30e3, 70e3})
    EXPECT_WITHIN_RELATIVE(south.density_ratio(h).value, north.density_ratio(h).value, 1e-9,
                           "rounding of years");
}

TEST(SeasonalAir, FindsTheAltitudeOfAPressure) {
  const SeasonalAir air(degrees(10), 2001.3);
  for (const double h : {100., 12e3, 45e3})
    EXPECT_WITHIN(air.altitude_m(air.pressure_ratio(h)), h, 1e-3, "halved 50 times");
  EXPECT_THROW(SeasonalAir(degrees(91), 2001), algebra::Error);
}

}  // namespace coppermoon::atmosphere::seasonal_air_test
