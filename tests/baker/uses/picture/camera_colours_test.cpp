// SPDX-License-Identifier: MIT
#include "uses/picture/camera_colours.h"

#include <glm/matrix.hpp>

#include "colour/camera_spectra.h"
#include "colour/working_space.h"
#include "support/testing.h"

namespace coppermoon::uses::camera_colours_test {

const std::string response = "canon-eos-600d";
const std::array<double, 3> deep_red = xyz_of_rec709(std::array{1., 0.1, 0.02}),
                            white = xyz_of_rec709(std::array{1., 1., 1.});

/// Gains as shot that make daylight white, in the channels of the sensor.
std::array<double, 3> of_daylight() {
  const auto daylight = colour::camera_spectra(response).daylight;
  return {daylight.g / daylight.r, 1, daylight.g / daylight.b};
}

CameraColours exact(CameraColours colours) {
  colours.lift = 0;
  return colours;
}

TEST(CameraColours, OfDaylightAreNeutral) {
  const auto colours = camera_colours(response, of_daylight());
  for (int k = 0; k < 3; ++k)
    EXPECT_WITHIN(colours.gains[k], 1, 1e-12, "the balance is daylight's inverse");
  const auto same = camera_colours(response, {});
  EXPECT_EQ(same.gains, glm::dvec3(1));
  for (const auto& seen : {colours, same})
    for (const double value : rec709_by(exact(seen), white, 0))
      EXPECT_WITHIN(value, 1, 1e-3, "white of XYZ and of the matrix have four digits");
}

TEST(CameraColours, OfNoSpectralResponseAreThoseOfRec709) {
  for (const auto& other :
       {std::optional<std::string>{}, std::optional<std::string>{"colorimetric"}}) {
    const auto rgb = rec709_by(exact(camera_colours(other, of_daylight())), deep_red, 0);
    EXPECT_WITHIN(rgb[0], 1, 1e-9, "inverse matrices in doubles");
    EXPECT_WITHIN(rgb[1], 0.1, 1e-9, "inverse matrices in doubles");
    EXPECT_WITHIN(rgb[2], 0.02, 1e-9, "inverse matrices in doubles");
  }
}

TEST(CameraColours, MultiplyTheSensorsChannelsBeforeTheyAreMixed) {
  auto gains = of_daylight();
  gains[0] *= 2;
  const auto colours = exact(camera_colours(response, gains)),
             neutral = exact(camera_colours(response, {}));
  const auto spectra = colour::camera_spectra(response);
  const glm::dvec3 xyz(deep_red[0], deep_red[1], deep_red[2]);
  auto channels = glm::inverse(spectra.xyz_from_balanced) * xyz;
  channels.r *= 2;
  const auto expected = colour::channels_from_xyz(colour::WorkingSpace::linear_rec709) *
                        spectra.xyz_from_balanced * channels;
  const double least = 0.003, floor = least * std::max({expected.r, expected.g, expected.b});
  const auto found = rec709_by(colours, deep_red, least),
             without = rec709_by(neutral, deep_red, least);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_WITHIN_RELATIVE(found[k], std::max(floor, expected[static_cast<int>(k)]), 1e-12,
                           "rounding");
  EXPECT_GT(found[0], 2 * without[0]) << "what green takes from red is not doubled";
  EXPECT_LT(found[1], without[1]) << "red takes from green";
}

TEST(CameraColours, OfPartsAddUpToTheWhole) {
  const auto colours = exact(camera_colours(response, std::array{1.5, 1., 2.2}));
  for (const auto& xyz : {deep_red, white}) {
    std::array<double, 3> sums{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto parts = parts_of(k, colours, xyz);
      sums[k] = parts.r + parts.g + parts.b;
    }
    const auto whole = rec709_by(colours, xyz, 0);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_WITHIN(whole[k], std::max(1e-12, sums[k]), 1e-12, "rounding; none is below 0");
  }
}

TEST(CameraColours, HaveAFloorBelowTheBrightestChannel) {
  const auto colours = exact(camera_colours({}, {}));
  const auto rgb = rec709_by(colours, xyz_of_rec709(std::array{1., -0.2, 1e-5}), 0.003);
  EXPECT_WITHIN(rgb[0], 1, 1e-9, "inverse matrices in doubles");
  EXPECT_WITHIN(rgb[1], 0.003, 1e-11, "0.003 of the brightest");
  EXPECT_WITHIN(rgb[2], 0.003, 1e-11, "0.003 of the brightest");
}

TEST(CameraColours, AddAShareOfTheBrightestChannelToAll) {
  auto colours = camera_colours({}, {});
  colours.lift = 0.02;
  const auto rgb = rec709_by(colours, xyz_of_rec709(std::array{2., 0.5, -0.2}), 0.003);
  EXPECT_WITHIN(rgb[0], 2.04, 1e-9, "inverse matrices in doubles");
  EXPECT_WITHIN(rgb[1], 0.54, 1e-9, "inverse matrices in doubles");
  EXPECT_WITHIN(rgb[2], 0.006 + 0.04, 1e-9, "added to the floor");
}

}  // namespace coppermoon::uses::camera_colours_test
