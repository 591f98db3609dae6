// SPDX-License-Identifier: MIT
#include "atmosphere/presets.h"

#include <gtest/gtest.h>

#include <string>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::atmosphere {
namespace {

TEST(Preset, OfThePaperIsItsSphereAndItsFilter) {
  const auto paper = preset("paper", algebra::degrees(20));
  EXPECT_TRUE(paper.symmetric());
  EXPECT_EQ(paper.top_radius_m(), 6.42e6);
  EXPECT_EQ(paper.column.ozone_du, 345);
  EXPECT_EQ(paper.column.cloud_cover, 0);
}

TEST(Preset, OfTheStandardIsTheRealEarth) {
  const auto standard = preset("standard", algebra::degrees(20));
  EXPECT_FALSE(standard.symmetric());
  EXPECT_WITHIN(standard.earth.polar_radius_m, 6356752, 2, "WGS 84 flattens by 1/298.257224");
  EXPECT_EQ(standard.top_m(), 86e3);
  EXPECT_EQ(standard.column.cloud_cover, 0.7);
}

TEST(Preset, AreAllValidAndOfTheirOrder) {
  double before = 1e9;
  for (const auto name : {"molecular", "clear", "standard"}) {
    const auto air = preset(name, algebra::degrees(-23));
    EXPECT_NO_THROW(require_valid(air));
    // what a ray at 8 km is left with, per metre and by cloud
    const auto green = sea_level_optics(algebra::nanometres(600), air.molecules);
    const double left = limb_filter(air.column, green, 8e3) /
                        extinction_per_m(air.column, green, 8e3);
    EXPECT_LT(left, before) << name;
    before = left;
  }
  EXPECT_NO_THROW(require_valid(preset("paper", {})));
  EXPECT_NO_THROW(require_valid(preset("none", {})));
}

TEST(Preset, RefusesANameThereIsNot) {
  try {
    preset("venus", {});
    FAIL();
  } catch (const algebra::Error& error) {
    EXPECT_EQ(std::string(error.what()),
              "atmosphere = venus, allowed paper, molecular, clear, standard, none");
  }
}

}  // namespace
}  // namespace coppermoon::atmosphere
