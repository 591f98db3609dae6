// SPDX-License-Identifier: MIT
#include "uses/fit/light_in_bins.h"

#include "support/testing.h"

namespace coppermoon::uses::light_in_bins_test {

constexpr double sun_m = 1.5e11, depth_m = 3.8e8;

/// Light of a wave around the axis on two planes, the farther one brighter by a tenth; dark in some sectors.
shadow::RefractedLight waving(std::size_t sectors, std::size_t first_dark, std::size_t dark) {
  const std::array distances_m{1e6, 2e6, 3e6, 4e6, 5e6};
  const std::array waves_nm{500., 600.};
  auto light = shadow::darkness({sun_m, {depth_m, 1.01 * depth_m}}, waves_nm, distances_m, sectors);
  for (std::size_t s = 0; s < sectors; ++s)
    if (s < first_dark || s >= first_dark + dark)
      for (std::size_t plane = 0; plane < 2; ++plane)
        for (double& value : light.ratio[plane * sectors + s].values())
          value = (1 + 0.1 * static_cast<double>(plane)) *
                  (2 + std::cos(2 * std::numbers::pi * static_cast<double>(s) /
                                static_cast<double>(sectors)));
  return light;
}

eclipse::ShadowPlace at(double angle_rad, double depth) {
  return {.axis_distance = algebra::metres(3e6),
          .position_angle = algebra::radians(angle_rad),
          .depth = algebra::metres(depth)};
}

TEST(RefractedAt, RunsOnCubicsBetweenSectorsAndStraightBetweenPlanes) {
  const auto light = waving(48, 0, 0);
  RefractedAt reader(light);
  std::array<double, 2> ratios;
  for (double angle = 0; angle < 2 * std::numbers::pi; angle += 0.01) {
    reader.read(at(angle, 1.005 * depth_m), ratios);
    EXPECT_WITHIN(ratios[0], 1.05 * (2 + std::cos(angle)), 8e-6,
                  "3/128 of a sector's fourth power: 7e-6")
        << angle;
    EXPECT_EQ(ratios[1], ratios[0]);
  }
}

TEST(RefractedAt, AsksForOneSectorMoreAtEitherEnd) {
  const auto light = waving(48, 8, 36), whole = waving(48, 0, 0);  // lit from 44 to 7
  RefractedAt reader(light), of_all(whole);
  std::array<double, 2> ratios, wanted;
  for (const double sector : {45., 45.5, 47.9, 0., 3.2, 5.9, 6.}) {
    const auto place = at(2 * std::numbers::pi * sector / 48, depth_m);
    reader.read(place, ratios);
    of_all.read(place, wanted);
    EXPECT_WITHIN_RELATIVE(ratios[0], wanted[0], 1e-14, "rounding") << sector;
  }
}

TEST(RefractedAt, OfOneSectorIsAlikeAllAround) {
  const auto light = waving(1, 0, 0);
  RefractedAt reader(light);
  std::array<double, 2> ratios;
  reader.read(at(4, depth_m), ratios);
  EXPECT_WITHIN_RELATIVE(ratios[0], 3., 1e-14, "rounding");
}

}  // namespace coppermoon::uses::light_in_bins_test
