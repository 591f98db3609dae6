// SPDX-License-Identifier: MIT
#include "uses/compare/comparison.h"

#include <glm/matrix.hpp>
#include "baker/texture/scratch_folder.h"
#include "colour/tone_curve.h"
#include "colour/working_space.h"

#include "support/testing.h"

namespace coppermoon::uses::comparison_test {

/// Pixels of 1 cd/m² at two distances; of those farther out some are black in the photograph.
std::vector<SharedPixel> pixels(std::size_t black) {
  std::vector<SharedPixel> all;
  for (std::size_t i = 0; i < 10; ++i) {
    all.push_back({1000, glm::dvec3(0.5), glm::dvec3(1), false});
    all.push_back({2000, glm::dvec3(i < black ? 0 : 0.5), glm::dvec3(1), false});
  }
  return all;
}

TEST(Differences, SayNothingWhereMostOfThePhotographIsBlack) {
  const auto most = differences(pixels(6), 0.5, 2);
  EXPECT_EQ(most[0].stops, 0.);
  EXPECT_EQ(most[1].black, 6);
  EXPECT_FALSE(most[1].stops || most[1].photo_uv || most[1].render_uv || most[1].delta_e_2000);
  const auto half = differences(pixels(5), 0.5, 2);
  EXPECT_EQ(half[1].stops, -1.);
}

/// Displayed light that stands for scene light with the mean curve of cameras.
double displayed_of(double scene) {
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (middle * std::exp(colour::tone_logarithm({}, middle)) < scene ? low : high) = middle;
  }
  return low;
}

/// Pixels from red and dark to grey and bright, as in the umbra, as a camera with these colours displays them through a
/// sky that alone is displayed as `sky`.
std::vector<SharedPixel> written_by(const CameraColours& colours,
                                    const glm::dvec3& sky = glm::dvec3(0)) {
  constexpr double exposure = 0.01;
  const auto to_xyz = glm::inverse(colour::channels_from_xyz(colour::WorkingSpace::linear_rec709));
  std::vector<SharedPixel> pixels;
  for (double light = 1; light < 60; light *= 1.001) {
    const double grey = light / 60;
    const glm::dvec3 rgb(light, (0.25 + 0.7 * grey) * light, (0.08 + 0.8 * grey) * light);
    const auto xyz = to_xyz * rgb;
    glm::dvec3 shown;
    for (int k = 0; k < 3; ++k) {
      const auto parts =
          parts_of(static_cast<std::size_t>(k), colours, std::array{xyz.x, xyz.y, xyz.z});
      const double added = sky[k] * std::exp(colour::tone_logarithm({}, sky[k]));
      shown[k] = displayed_of(exposure * (parts.r + parts.g + parts.b) + added);
    }
    pixels.push_back({1000, shown, rgb, false});
  }
  return pixels;
}

TEST(FittedWriting, FindsTheGainsOfRedAndBlue) {
  for (const char* response : {"canon-eos-600d", "colorimetric"})
    for (const glm::dvec3 gains :
         {glm::dvec3(0.6, 1, 1.7), glm::dvec3(1), glm::dvec3(1.3, 1, 0.8)}) {
      SCOPED_TRACE(testing::Message() << response << " " << gains.r << " " << gains.b);
      auto colours = camera_colours(response, {});
      colours.gains = gains;
      const auto pixels = written_by(colours);
      colours.gains = glm::dvec3(1);
      const auto found = fitted_writing(pixels, colours);
      const char* reason =
          "light is binned in steps of 10 %, of which a median over many steps keeps a tenth; the "
          "prior of 0.3 about 1 draws by (0.03 / 0.3)^2 over the number of steps, 1e-3 at most";
      EXPECT_WITHIN_RELATIVE(found.colours.gains.r, gains.r, 0.01, reason);
      EXPECT_WITHIN_RELATIVE(found.colours.gains.b, gains.b, 0.01, reason);
      EXPECT_EQ(found.colours.gains.g, 1);
      for (std::size_t k = 0; k < colour::tone_components; ++k)
        EXPECT_WITHIN(found.curve.numbers[k], 0, 0.5, "half the scatter of cameras");
    }
}

TEST(FittedWriting, IgnoresLightOfWhichTheSkyIsMoreThanAThird) {
  auto colours = camera_colours("canon-eos-600d", {});
  colours.gains = {0.6, 1, 1.7};
  const glm::dvec3 sky(0, 0.001, 0.0056);  // levels 3 and 17 of 255
  const auto pixels = written_by(colours, sky);
  colours.gains = glm::dvec3(1);
  const auto blue = [&](const auto&... told) {
    return fitted_writing(pixels, colours, told...).colours.gains.b / 1.7;
  };
  EXPECT_GT(blue(), 1.2);
  EXPECT_WITHIN_RELATIVE(blue(sky), 1, 0.1,
                         "sky adds a half to the darkest light used, 9 % averaged over the steps");
}

TEST(FittedWriting, RefusesTooFewSteps) { EXPECT_ERROR(fitted_writing({}, {}), "steps of light"); }

}  // namespace coppermoon::uses::comparison_test
