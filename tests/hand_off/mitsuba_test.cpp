// SPDX-License-Identifier: MIT
// Mitsuba's frame of a scene is POV-Ray's.
#include "povray_scenes/mitsuba.h"
#include "povray_scenes/render.h"
#include "support/program.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace coppermoon::hand_off::mitsuba_test {

class Mitsuba : public ProgramTest {
 protected:
  texture::Image rendered_in(const std::string& folder) const {
    const auto outcome =
        run(words_of("{} -m scalar_rgb -o frame.exr {}", COPPERMOON_HAND_OFF_PYTHON "/bin/mitsuba",
                     povray_scenes::mitsuba_file),
            {.folder = here(folder)});
    EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
    return texture::read_image(here(folder) / "frame.exr");
  }
};

/// Pixels whose surroundings within two pixels are all lit: no limb, where a pixel is a matter of its rays.
std::vector<std::size_t> within_the_disc(const texture::Image& frame) {
  std::vector<std::size_t> pixels;
  for (std::size_t r = 2; r + 2 < frame.height; ++r)
    for (std::size_t c = 2; c + 2 < frame.width; ++c) {
      bool lit = true;
      for (std::size_t i = r - 2; i <= r + 2; ++i)
        for (std::size_t j = c - 2; j <= c + 2; ++j) lit &= frame(i, j, 0) > 0;
      if (lit) pixels.push_back(r * frame.width + c);
    }
  return pixels;
}

void expect_one_picture(const texture::Image& theirs, const texture::Image& ours) {
  ASSERT_EQ(theirs.values.size(), ours.values.size());
  const auto pixels = within_the_disc(ours);
  ASSERT_GT(pixels.size(), 10000U);
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0, reference = 0, squares = 0;
    for (const auto pixel : pixels) {
      const double a = theirs.values[3 * pixel + k], b = ours.values[3 * pixel + k];
      sum += a, reference += b;
      if (b > 1e-4)  // POV-Ray's frame is of halves: steps of 3e-8 below 6e-5
        squares += (a / b - 1) * (a / b - 1);
    }
    EXPECT_WITHIN_RELATIVE(sum, reference, 1e-3, "64 rays in each of ten thousand pixels");
    EXPECT_LT(std::sqrt(squares / static_cast<double>(pixels.size())), 0.01)
        << "a hundredth, pixel by pixel: the noise of 64 rays over a pixel's detail is 0.4 %";
  }
}

class MitsubaSees : public Mitsuba, public testing::WithParamInterface<Words> {};

TEST_P(MitsubaSees, ThePictureThatPovRaySees) {
  Words scene{"scene", "--albedo-map", "built-in", "--atmosphere", "undated", "--width",
              "240",   "--height",     "160",      "--up",         "zenith",  "--texture-width",
              "1024"};
  scene.insert(scene.begin() + 1, GetParam().begin(), GetParam().end());
  const auto write = [&](const std::string& renderer) {
    auto words = scene;
    words += Words{"--for", renderer, "-o", renderer};
    if (renderer == "povray") words += Words{"--sky", "off"};
    expect_done(coppermoon(words));
  };
  write("povray");
  write("mitsuba");
  expect_one_picture(rendered_in("mitsuba"),
                     texture::read_image(povray_scenes::render(here("povray"))));
}

// high in the sky, before the middle; low, flattened by a twelfth
INSTANTIATE_TEST_SUITE_P(AtPlaces, MitsubaSees,
                         testing::Values(Words{"2018-07-27T19:35:00Z", "--at", "Nairobi", "--field",
                                               "0.7"},
                                         Words{"2018-07-27T20:21:45Z", "--at", "52.9,-3.9"}));

}  // namespace coppermoon::hand_off::mitsuba_test
