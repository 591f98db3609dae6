// SPDX-License-Identifier: MIT
#include "colour/display.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::colour {
namespace {

using enum WorkingSpace;

/// IEC 61966-2-1, extended as an odd function's straight part below 0.
double srgb_code(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

Image image_of(const std::vector<Rgb>& colours) {
  Image image(1, colours.size());
  std::ranges::copy(colours, image.values().begin());
  return image;
}

float grey_shown(float grey, const Development& development) {
  return developed(image_of({{grey, grey, grey}}), linear_rec709, development)(0, 0)[1];
}

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const algebra::Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Display, CodesSrgbByTheFormulaOfTheStandard) {
  for (const float grey : {0.0f, 0.001f, 0.0031f, 0.0032f, 0.018f, 0.18f, 0.5f, 1.0f})
    EXPECT_WITHIN(grey_shown(grey, {}), srgb_code(grey), 2e-5,
                  "the standard's two pieces do not meet exactly; OpenColorIO's do");
}

TEST(Display, LeavesColoursWithoutToneMappingAsTheyAre) {
  const auto shown =
      developed(image_of({{0.5f, 0.05f, -0.01f}, {3.0f, 0.2f, 0.7f}}), linear_rec709);
  const double linear[2][3] = {{0.5, 0.05, -0.01}, {3.0, 0.2, 0.7}};
  for (std::size_t p = 0; p < 2; ++p)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_WITHIN(shown(0, p)[i], srgb_code(linear[p][i]), 5e-5,
                    "OpenColorIO's slope at 0 is 12.923; not clamped at either end");
}

TEST(Display, ShowsMiddleGreyThroughAcesAtATenthOfWhite) {
  // The ACES output transform puts 0.18 at 4.8 of 48 cd/m²; for video's dim surround, to the power
  // 0.9811.
  EXPECT_WITHIN(grey_shown(0.18f, {.view = "ACES 1.0 SDR Video"}), srgb_code(std::pow(0.1, 0.9811)),
                2e-3, "half an 8-bit step");
}

TEST(Display, RollsHighlightsOffThroughAces) {
  const Development aces{.view = "ACES 1.0 SDR Video"};
  EXPECT_LT(grey_shown(1.0f, aces), 0.85f);
  EXPECT_LT(grey_shown(8.0f, aces), 1.0f);
  EXPECT_GT(grey_shown(8.0f, aces), grey_shown(4.0f, aces));
}

TEST(Display, ExposesBeforeTheView) {
  // A full Moon of 5000 cd/m² at 1/20000 is a quarter.
  EXPECT_WITHIN(grey_shown(5000.0f, {.scale = 1 / 20000.0}), srgb_code(0.25), 2e-5,
                "as unexposed greys");
}

TEST(Display, ShowsTheSameColourFromEveryWorkingSpace) {
  const glm::dvec3 xyz{0.35, 0.30, 0.12};
  std::vector<Rgb> shown;
  for (const auto space : {linear_rec709, acescg, ciexyz_d65}) {
    const auto c = channels_from_xyz(space) * xyz;
    const Rgb colour{static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)};
    shown.push_back(developed(image_of({colour}), space)(0, 0));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_WITHIN(shown[1][i], shown[0][i], 1e-5,
                  "the configuration derives its matrices in floats");
    EXPECT_WITHIN(shown[2][i], shown[0][i], 1e-5,
                  "the configuration derives its matrices in floats");
  }
}

TEST(Display, LeavesRawAlone) {
  const auto shown = developed(image_of({{0.1f, 2.0f, 700.0f}}), acescg, {.view = "Raw"});
  EXPECT_EQ(shown(0, 0), (Rgb{0.1f, 2.0f, 700.0f}));
}

TEST(Display, LogIsAcescct) {
  // ACEScct (S-2016-001): (log2(x) + 9.72) / 17.52, so 0.18 is 0.413588.
  EXPECT_WITHIN(grey_shown(0.18f, {.view = "Log"}), 0.413588, 2e-6, "printed to 6 digits");
}

TEST(Display, ShowsAPictureAsItShowsItsPixels) {
  Image image(300, 7);
  for (std::size_t row = 0; row < image.rows(); ++row)
    for (std::size_t column = 0; column < image.columns(); ++column)
      image(row, column) = {0.003f * static_cast<float>(row), 0.1f * static_cast<float>(column),
                            0.4f};
  const Development aces{.view = "ACES 1.0 SDR Video"};
  const auto shown = developed(image, linear_rec709, aces);
  for (const auto row : {0u, 8u, 150u, 299u})
    for (const auto column : {0u, 6u})
      EXPECT_EQ(shown(row, column),
                developed(image_of({image(row, column)}), linear_rec709, aces)(0, 0));
}

TEST(Display, HasTheViewsItPromises) {
  EXPECT_EQ(views(),
            (std::vector<std::string>{"Un-tone-mapped", "ACES 1.0 SDR Video", "Log", "Raw"}));
  EXPECT_EQ(displays(),
            (std::vector<std::string>{"sRGB", "Rec.1886 Rec.709", "P3-D65", "Rec.2100-PQ"}));
}

TEST(Display, ShowsEveryViewOfEveryDisplay) {
  for (const auto& display : displays())
    for (const auto& view : views(display)) {
      const float shown = grey_shown(0.5f, {.view = view, .display = display});
      EXPECT_TRUE(shown > 0 && shown < 1) << display << ", " << view << ": " << shown;
    }
}

TEST(Display, CodesPqByTheFormulaOfTheStandard) {
  // SMPTE ST 2084: 1 of the scene is 100 cd/m², coded 0.508078.
  EXPECT_WITHIN(grey_shown(1.0f, {.display = "Rec.2100-PQ"}), 0.508078, 1e-5,
                "the curve is tabulated");
}

TEST(Display, NamesTheViewsWhenItHasNoSuchView) {
  EXPECT_EQ(error_of([] { grey_shown(1, {.view = "Filmic"}); }),
            R"(view "Filmic", allowed "Un-tone-mapped", "ACES 1.0 SDR Video", "Log", "Raw")");
  EXPECT_EQ(error_of([] { grey_shown(1, {.display = "CRT"}); }),
            R"(display "CRT", allowed "sRGB", "Rec.1886 Rec.709", "P3-D65", "Rec.2100-PQ")");
  EXPECT_EQ(error_of([] { views("CRT"); }), error_of([] { grey_shown(1, {.display = "CRT"}); }));
}

TEST(Display, RefusesPixelsThatAreNoNumbers) {
  Image image(2, 3);
  image(1, 2)[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(error_of([&] { developed(image, linear_rec709); }),
            "row 1, column 2: nan exposed by 1 is not finite");
  image(1, 2)[0] = std::numeric_limits<float>::infinity();
  EXPECT_NE(error_of([&] { developed(image, linear_rec709); }), "no error");
  EXPECT_NE(error_of([] { grey_shown(1e30f, {.scale = 1e20}); }), "no error");
}

TEST(Display, RefusesAnExposureThatShowsNothing) {
  for (const double scale : {0.0, -1.0, std::nan("")})
    EXPECT_NE(error_of([&] { grey_shown(1, {.scale = scale}); }), "no error");
}

TEST(Display, DevelopsNothingIntoNothing) { EXPECT_TRUE(developed({}, acescg).empty()); }

TEST(Display, TakesAConfigurationOfTheUsers) {
  const auto path = std::filesystem::temp_directory_path() /
                    ("coppermoon_display_test_" + std::to_string(std::random_device{}()) + ".ocio");
  auto text = std::string(config_text());
  for (auto at = text.find("ACES 1.0 SDR Video"); at != text.npos;
       at = text.find("ACES 1.0 SDR Video"))
    text.replace(at, 18, "My own view");
  std::ofstream(path) << text;
  EXPECT_EQ(views("sRGB", path)[1], "My own view");
  EXPECT_EQ(grey_shown(0.3f, {.view = "My own view", .config = path}),
            grey_shown(0.3f, {.view = "ACES 1.0 SDR Video"}));
  std::filesystem::remove(path);
}

TEST(Display, RefusesAConfigurationThatIsNone) {
  EXPECT_TRUE(error_of([] { views("sRGB", "/no/such.ocio"); }).starts_with("/no/such.ocio: "));
}

TEST(Display, HasBuiltInTheConfigurationThatIsInstalled) {
  const auto installed = text_of(COPPERMOON_TEST_DATA "/../colour/config.ocio");
  ASSERT_FALSE(installed.empty());
  EXPECT_EQ(config_text(), installed);
}

}  // namespace
}  // namespace coppermoon::colour
