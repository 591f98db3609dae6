// SPDX-License-Identifier: MIT
#include "colour/exposure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::colour {
namespace {

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

}  // namespace
}  // namespace coppermoon::colour
