// SPDX-License-Identifier: MIT
#include "colour/exposure.h"

#include "support/testing.h"

namespace coppermoon::colour::exposure_test {

TEST(Exposure, SaturatesAtTheLuminanceOfIso12232) {
  // At EV100 = 0 (1 s, f/1, ISO 100) the sensor saturates at 78 / (0.65 · 100) = 1.2 cd/m².
  const double scale = exposure_scale({.time_s = 1, .f_number = 1, .iso = 100});
  EXPECT_WITHIN(1.2 * scale, 1.0, 1e-12, "rounding");
}

TEST(Exposure, OfAnEclipsedMoonWorkedByHand) {
  // 0.5 cd/m², 2 s at f/5.6 and ISO 800: 0.65 · 0.5 · 2 · 800 / (78 · 31.36) = 520 / 2446.08.
  EXPECT_WITHIN(0.5 * exposure_scale({.time_s = 2, .f_number = 5.6, .iso = 800}), 0.212585, 5e-7,
                "worked to 6 digits");
}

TEST(Exposure, IsTheSameForTheSameLight) {
  const double scale = exposure_scale({.time_s = 1, .f_number = 4, .iso = 200});
  EXPECT_WITHIN_RELATIVE(exposure_scale({.time_s = 4, .f_number = 8, .iso = 200}), scale, 1e-15,
                         "rounding");
  EXPECT_WITHIN_RELATIVE(exposure_scale({.time_s = 0.5, .f_number = 4, .iso = 400}), scale, 1e-15,
                         "rounding");
}

TEST(Exposure, RefusesWhatNoCameraHas) {
  EXPECT_THROW(exposure_scale({.time_s = 0}), algebra::Error);
  EXPECT_THROW(exposure_scale({.f_number = -8}), algebra::Error);
  EXPECT_THROW(exposure_scale({.iso = 0}), algebra::Error);
  EXPECT_THROW(exposure_scale({.iso = std::nan("")}), algebra::Error);
}

TEST(RealSettings, AreThirdsAndHalvesOfStops) {
  // the two columns "nominal" and "precise" of scantips.com/lights/fstop2.html
  for (const auto& [shown, real] : {std::pair{30., 32.},
                                    {15., 16.},
                                    {13., 12.6992},
                                    {1.3, 1.25992},
                                    {0.7, 0.707107},
                                    {0.6, 0.629961},
                                    {0.3, 0.31498},
                                    {1.5, 1.41421},
                                    {1. / 3, 0.31498},
                                    {1. / 4, 0.25},
                                    {1. / 6, 0.15749},
                                    {1. / 15, 1. / 16},
                                    {1. / 30, 1. / 32},
                                    {1. / 60, 1. / 64},
                                    {1. / 90, 1. / 90.5097},
                                    {1. / 125, 1. / 128},
                                    {1. / 160, 1. / 161.27},
                                    {1. / 1000, 1. / 1024},
                                    {1. / 8000, 1. / 8192}})
    EXPECT_WITHIN_RELATIVE(real_time_s(shown), real, 1e-5, "the table's digits") << shown;
  for (const auto& [shown, real] : {std::pair{1.2, 1.18921},
                                    {3.5, 3.5636},
                                    {5.6, 5.65685},
                                    {6.3, 6.3496},
                                    {11., 11.3137},
                                    {13., 12.6992},
                                    {22., 22.6274}})
    EXPECT_WITHIN_RELATIVE(real_f_number(shown), real, 1e-5, "the table's digits") << shown;
  for (const auto& [shown, real] :
       {std::pair{100., 100.}, {125., 125.992}, {1250., 1269.92}, {6400., 6400.}})
    EXPECT_WITHIN_RELATIVE(real_iso(shown), real, 1e-5, "the table's digits") << shown;
}

TEST(RealSettings, LeaveWhatNoCameraShows) {
  for (const double time_s : {0.0421, 1. / 32, 1. / 47, 45., 60.})
    EXPECT_DOUBLE_EQ(real_time_s(time_s), time_s);
  EXPECT_DOUBLE_EQ(real_f_number(7.5), 7.5);
  EXPECT_DOUBLE_EQ(real_iso(34), 34);
}

}  // namespace coppermoon::colour::exposure_test
