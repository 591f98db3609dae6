// SPDX-License-Identifier: MIT
#include "atmosphere/presets.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::presets_test {

TEST(Preset, OfThePaperIsItsSphereAndItsFilter) {
  const auto paper = preset("paper", algebra::degrees(20));
  EXPECT_TRUE(paper.symmetric());
  EXPECT_EQ(paper.top_radius_m(), 6.42e6);
  EXPECT_EQ(paper.column.ozone_du, 345);
  EXPECT_EQ(paper.column.cloud_cover, 0);
}

TEST(Preset, OfTheStandardIsTheAirOfAMonth) {
  const auto july = preset("standard", algebra::degrees(20), 2001.54),
             january = preset("standard", algebra::degrees(-20), 2001.04);
  ASSERT_EQ(july.belts.size(), 13U);
  EXPECT_NO_THROW(require_valid(july));
  const auto at = [](const Atmosphere& air, std::size_t belt) { return air.belts[belt].column; };
  EXPECT_GT(at(january, 1).ozone_du, at(july, 1).ozone_du + 30) << "the north has most in spring";
  EXPECT_GT(at(july, 6).tropopause_m, 15e3) << "the equator's";
  EXPECT_LT(at(july, 12).tropopause_m, 10.5e3) << "the far south's";
  EXPECT_GT(density_ratio(at(january, 0), 0).value, density_ratio(at(january, 6), 0).value)
      << "cold air is dense";
  EXPECT_EQ(at(july, 3).cloud_cover, 0) << "cloud is a chance, not a deck";
  EXPECT_GT(
      preset("standard", {}, 1992.1).belts[6].column.stratospheric_layer->optical_depth(),
      10 * preset("standard", {}, 2003.1).belts[6].column.stratospheric_layer->optical_depth())
      << "Pinatubo";
}

TEST(Preset, CalibratedHasThreeFifthsOfTheStandardsCloud) {
  const auto standard = preset("standard", {}, 2001.5),
             calibrated = preset("calibrated", {}, 2001.5);
  for (std::size_t belt = 0; belt < standard.belts.size(); ++belt)
    EXPECT_EQ(calibrated.belts[belt].column.cloud_per_m,
              0.6 * standard.belts[belt].column.cloud_per_m)
        << "docs/air.md";
}

TEST(Preset, OfTheStandardStandsOverTheLatitudesOfTheLimb) {
  EXPECT_WITHIN(algebra::in_degrees(latitude_on_limb(0, algebra::degrees(20))), 70, 1e-9,
                "90 - 20");
  EXPECT_WITHIN(algebra::in_degrees(latitude_on_limb(1.2, algebra::degrees(0))),
                90 - 1.2 * 180 / 3.14159265358979, 1e-9, "an equinox: the limb is a meridian");
}

TEST(Preset, OfUndatedAirIsTheRealEarthAlikeAllAround) {
  const auto standard = preset("undated", algebra::degrees(20));
  EXPECT_FALSE(standard.symmetric());
  EXPECT_WITHIN(standard.earth.polar_radius_m, 6356752, 2, "WGS 84 flattens by 1/298.257224");
  EXPECT_EQ(standard.top_m(), 86e3);
  EXPECT_EQ(standard.column.cloud_cover, 0.7);
}

TEST(Preset, AreAllValidAndOfTheirOrder) {
  double before = 1e9;
  for (const auto name : {"molecular", "clear", "undated"}) {
    const auto air = preset(name, algebra::degrees(-23));
    EXPECT_NO_THROW(require_valid(air));
    // what a ray at 8 km is left with, per metre and by cloud
    const auto green = sea_level_optics(algebra::nanometres(600), air.molecules);
    const double left =
        limb_filter(air.column, green, 8e3) / extinction_per_m(air.column, green, 8e3);
    EXPECT_LT(left, before) << name;
    before = left;
  }
  EXPECT_NO_THROW(require_valid(preset("paper", {})));
  EXPECT_NO_THROW(require_valid(preset("none", {})));
}

TEST(Preset, RefusesANameThereIsNot) {
  EXPECT_EQ(
      refusal_of([] { preset("venus", {}); }),
      "atmosphere = venus, allowed paper, molecular, clear, undated, standard, calibrated, none");
}

}  // namespace coppermoon::atmosphere::presets_test
