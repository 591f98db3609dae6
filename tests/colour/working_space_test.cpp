// SPDX-License-Identifier: MIT
#include "colour/working_space.h"

#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

#include "colour/cie_observer.h"
#include "support/testing.h"

namespace coppermoon::colour::working_space_test {

using enum WorkingSpace;

constexpr std::array spaces{linear_rec709, acescg, ciexyz_d65};

const glm::dvec3 d65_white{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};

void expect_rows(const glm::dmat3& matrix, const double (&rows)[3][3], double tolerance,
                 const char* reason) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      EXPECT_WITHIN(matrix[column][row], rows[row][column], tolerance, reason);
}

/// A colour of one wavelength: outside every RGB space or on its edge.
std::array<double, 3> monochromatic(WorkingSpace space, double nm) {
  const auto weights = channel_weights(space, std::array{nm - 1, nm + 1});
  return {weights(0, 0), weights(1, 0), weights(2, 0)};
}

TEST(WorkingSpace, HasTheMatrixPrintedInTheSrgbStandard) {
  expect_rows(channels_from_xyz(linear_rec709),
              {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}},
              5e-4, "IEC 61966-2-1 inverts a matrix rounded to 4 digits");
}

TEST(WorkingSpace, GivesAcescgThePublishedMatrixFromRec709) {
  expect_rows(channels_from_xyz(acescg) * glm::inverse(channels_from_xyz(linear_rec709)),
              {{0.6131, 0.3395, 0.0474}, {0.0702, 0.9164, 0.0135}, {0.0206, 0.1096, 0.8698}}, 1e-4,
              "printed to 4 digits; white points rounded to 4 or 5");
}

TEST(WorkingSpace, SeesD65AsEqualChannels) {
  for (const auto space : {linear_rec709, acescg}) {
    const auto white = channels_from_xyz(space) * d65_white;
    for (int i = 0; i < 3; ++i) EXPECT_WITHIN(white[i], 1.0, 1e-12, "rounding");
  }
}

TEST(WorkingSpace, LuminanceIsYOfTheColour) {
  const glm::dvec3 xyz{0.7, 0.3, 1.1};
  for (const auto space : spaces) {
    const auto c = channels_from_xyz(space) * xyz;
    EXPECT_WITHIN(luminance(space, std::array{c.x, c.y, c.z}), 0.3, 1e-12, "rounding");
  }
}

TEST(WorkingSpace, LuminanceOfRec709PrimariesIsThatOfTheStandard) {
  EXPECT_WITHIN(luminance(linear_rec709, std::array{1.0, 0.0, 0.0}), 0.2126, 5e-5,
                "BT.709 prints 4 digits");
  EXPECT_WITHIN(luminance(linear_rec709, std::array{0.0, 1.0, 0.0}), 0.7152, 5e-5,
                "BT.709 prints 4 digits");
  EXPECT_WITHIN(luminance(linear_rec709, std::array{0.0, 0.0, 1.0}), 0.0722, 5e-5,
                "BT.709 prints 4 digits");
}

TEST(WorkingSpace, ChannelWeightsKeepTheLuminanceOfEveryBand) {
  const std::array edges{380.0, 450.0, 520.0, 600.0, 780.0};
  const auto xyz = xyz_weights(edges);
  for (const auto space : spaces) {
    const auto weights = channel_weights(space, edges);
    for (std::size_t band = 0; band < weights.columns(); ++band)
      EXPECT_WITHIN_RELATIVE(
          luminance(space, std::array{weights(0, band), weights(1, band), weights(2, band)}),
          xyz(1, band), 1e-12, "rounding");
  }
}

TEST(WorkingSpace, HeaderChromaticitiesGiveBackThePrimaries) {
  const std::array<float, 8> rec709{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  EXPECT_EQ(chromaticities(linear_rec709), rec709);
  const std::array<float, 8> ap1{0.713f, 0.293f, 0.165f, 0.83f, 0.128f, 0.044f, 0.32168f, 0.33767f};
  EXPECT_EQ(chromaticities(acescg), ap1);
  const auto xyz = chromaticities(ciexyz_d65);
  EXPECT_WITHIN(xyz[6], 1.0 / 3, 1e-7, "float: X = Y = Z = 1 is the equal-energy white");
}

TEST(WorkingSpace, IsKnownByItsNames) {
  for (const auto space : spaces)
    for (const auto alias : aliases(space)) EXPECT_EQ(working_space(alias), space);
  EXPECT_EQ(name(linear_rec709), "lin_rec709");
  EXPECT_EQ(interop_id(linear_rec709), "lin_rec709_scene");
  EXPECT_EQ(interop_id(acescg), "lin_ap1_scene");
  EXPECT_EQ(interop_id(ciexyz_d65), "lin_ciexyzd65_scene");
  EXPECT_EQ(working_space("lin_srgb"), linear_rec709);
  EXPECT_EQ(working_space("ACEScg"), acescg);
}

TEST(WorkingSpace, IsSaidByAFilesNameOrAnotherIs) {
  EXPECT_EQ(space_in_name("Moon_ACEScg.0001"), acescg);
  EXPECT_EQ(space_in_name("moon_aces"), std::nullopt);
  for (const char* name : {"moon_aces", "ACES2065-1_moon", "moon.AP1", "moon_p3"})
    EXPECT_TRUE(names_another_space(name)) << name;
  for (const char* name : {"moon", "places", "map1", "step3", "moon_acescg", "moon_lin_ap1"})
    EXPECT_FALSE(names_another_space(name)) << name;
}

TEST(WorkingSpace, RefusesANameItDoesNotKnow) {
  EXPECT_EQ(refusal_of([] { working_space("adobe"); }),
            "working space \"adobe\", allowed lin_rec709, acescg or lin_ciexyzd65_scene");
}

TEST(IntoGamut, LeavesNoChannelNegativeAndKeepsTheLuminance) {
  for (const auto space : spaces)
    for (double nm = 390; nm <= 750; nm += 10) {
      auto colour = monochromatic(space, nm);
      const double before = luminance(space, colour);
      into_gamut(space, colour);
      EXPECT_GE(*std::ranges::min_element(colour), 0) << nm;
      EXPECT_WITHIN_RELATIVE(luminance(space, colour), before, 1e-9,
                             "rounding, where violet has 150 times more Z than Y");
    }
}

TEST(IntoGamut, StopsAtTheEdge) {
  auto colour = monochromatic(linear_rec709, 500);
  ASSERT_LT(*std::ranges::min_element(colour), 0) << "500 nm is outside Rec.709";
  into_gamut(linear_rec709, colour);
  EXPECT_WITHIN(*std::ranges::min_element(colour), 0.0, 1e-12, "the lowest channel lands on 0");
}

TEST(IntoGamut, MovesStraightTowardsGrey) {
  // W3C, CSS Color 4: red has Y = 0.212639, green 0.715169. (1, −0.1, 0) has Y = 0.1411221, so
  // green reaches 0 at 0.1 / 0.2411221 of the way to grey.
  constexpr double Y = 0.1411221, share = 0.1 / 0.2411221;
  std::array colour{1.0, -0.1, 0.0};
  into_gamut(linear_rec709, colour);
  EXPECT_WITHIN(colour[0], 1 - (1 - Y) * share, 2e-6, "luminances printed to 6 digits");
  EXPECT_WITHIN(colour[1], 0.0, 1e-12, "rounding");
  EXPECT_WITHIN(colour[2], Y * share, 2e-6, "luminances printed to 6 digits");
}

TEST(IntoGamut, LeavesColoursInsideAlone) {
  std::array colour{0.0, 2.5e4, 1e-7};
  into_gamut(acescg, colour);
  EXPECT_EQ(colour, (std::array{0.0, 2.5e4, 1e-7}));
}

TEST(IntoGamut, RefusesWhatIsNoLight) {
  std::array negative{-1.0, -1.0, -1.0},
      infinite{std::numeric_limits<double>::infinity(), 0.0, 0.0}, nothing{std::nan(""), 0.0, 0.0};
  EXPECT_THROW(into_gamut(linear_rec709, negative), algebra::Error);
  EXPECT_THROW(into_gamut(linear_rec709, infinite), algebra::Error);
  EXPECT_THROW(into_gamut(linear_rec709, nothing), algebra::Error);
}

}  // namespace coppermoon::colour::working_space_test
