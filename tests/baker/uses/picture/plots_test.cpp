// SPDX-License-Identifier: MIT
#include "uses/picture/plots.h"

#include "support/testing.h"

namespace coppermoon::uses::plots_test {

struct Rgb {
  long red, green, blue;
};

Rgb colour_at(double wavelength_nm) {
  const auto code = std::stol(plot_colour(wavelength_nm).substr(1), nullptr, 16);
  return {code >> 16, code >> 8 & 255, code & 255};
}

TEST(ShadowPlot, DrawsAWavelengthInItsOwnColour) {
  const auto blue = colour_at(450), green = colour_at(540), red = colour_at(650);
  EXPECT_GT(blue.blue, 2 * std::max(blue.red, blue.green));
  EXPECT_GT(green.green, 2 * std::max(green.red, green.blue));
  EXPECT_GT(red.red, 2 * std::max(red.green, red.blue));
  EXPECT_NE(plot_colour(650), plot_colour(700));
  for (int nm = 380; nm <= 780; nm += 10) EXPECT_EQ(plot_colour(nm).size(), 7U) << nm;
}

TEST(ShadowPlot, MarksTheShadowsEdgesWhereAlmanacsHaveThem) {
  const auto marks = marks_of({149.6e9, {384400e3}}, {}, "");
  EXPECT_WITHIN(
      marks.umbra_m, 4670e3, 40e3,
      "6378 (1.01) - 384400 (696000 - 6378) / 149.6e6 km, to the convention's choice of r");
  EXPECT_WITHIN(marks.penumbra_m, 8250e3, 40e3, "the same with a plus");
  EXPECT_FALSE(marks.moon_m);
}

}  // namespace coppermoon::uses::plots_test
