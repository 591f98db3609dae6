// SPDX-License-Identifier: MIT
// Stellarium itself, on a screen that nobody sees: its Moon is the texture, where and how our camera has
// it, and nothing of its own is added.
#include "end_to_end/spotted_moon.h"
#include "hand_off/agreement.h"
#include "hand_off/blender.h"
#include "hand_off/reference_projection.h"
#include "support/testing.h"

namespace coppermoon::hand_off::stellarium_test {

using povray_scenes::Up;

constexpr std::size_t width = 1024, height = 768;
constexpr double field_across_deg =
    0.7 * width / height;  // the script's 0.7 degrees are those of the height

/// High in the sky; umbra alone, and sunlight beside umbra.
const Look in_umbra = from_the_north(Up::zenith);
const Look partial{
    "2018-07-27T21:40:00Z", {algebra::degrees(-33.9), algebra::degrees(18.4), {}}, Up::zenith};

povray_scenes::SceneCamera camera_of(const Look& look) {
  return povray_scenes::camera_at(look.sky(), look.view(), look.up,
                                  {algebra::degrees(field_across_deg), width, height});
}

class Stellarium : public ProgramTest {
 protected:
  void bake(const Look& look, const Words& more) const {
    auto words = words_of("bake {} --at {} --texture-width 1024 -o moon.stellarium", look.instant,
                          at(look.observer));
    words += more;
    expect_done(coppermoon(words));
  }

  /// What it shows once its Moon is there, which a busy machine delays.
  texture::Image shown() const {
    const auto script = here("moon.stellarium/scripts/startup.ssc");
    const auto ours = text_of(script);
    texture::Image frame;
    for (const int seconds : {8, 30, 90}) {
      std::ofstream(script) << ours << "core.setGuiVisible(false);\n"
                            << "core.wait(" << seconds << ");\n"
                            << "core.screenshot(\"shown\", false, \"" << here().string()
                            << "\", true, \"png\");\ncore.wait(1);\ncore.quitStellarium();\n";
      start();
      frame = texture::read_image(here("shown.png"));
      if (frame(height / 2, width / 2, 0) > 0.02F) break;
    }
    std::ofstream(script) << ours;
    return frame;
  }

  void start() const {
    const auto outcome =
        run(words_of("env {} TMPDIR=/tmp LIBGL_ALWAYS_SOFTWARE=1 xvfb-run -a -s '-screen 0 "
                     "1024x768x24' timeout 300 stellarium --user-dir {} --full-screen no",
                     "HOME=" + here().string(), here("moon.stellarium")));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_SAYS_NOT(outcome.err, "shader program");
  }

  /// The texture before our own camera, in the numbers of the picture.
  texture::Image expected(const Look& look) const {
    return reference_projection(texture::read_image(here("moon.stellarium/textures/moon_4k.jpg")),
                                camera_of(look));
  }
};

/// Without what is more than 2 px beyond the limb: stars, and the Moon's name.
texture::Image disc_alone(texture::Image frame, double radius) {
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      const glm::dvec2 place{static_cast<double>(c) + 0.5 - width / 2.,
                             static_cast<double>(r) + 0.5 - height / 2.};
      if (glm::length(place) < radius + 2) continue;
      for (std::size_t k = 0; k < 3; ++k) frame(r, c, k) = 0;
    }
  return frame;
}

/// Mean over the disc of how far a channel is from what is expected, in steps of 1/255.
double mean_steps(const texture::Image& frame, const texture::Image& expected, double radius) {
  double sum = 0, count = 0;
  for (std::size_t r = 0; r < frame.height; ++r)
    for (std::size_t c = 0; c < frame.width; ++c) {
      const glm::dvec2 place{static_cast<double>(c) + 0.5 - width / 2.,
                             static_cast<double>(r) + 0.5 - height / 2.};
      if (glm::length(place) > radius - 2) continue;
      for (std::size_t k = 0; k < 3; ++k, ++count)
        sum += 255 * std::abs(frame(r, c, k) - expected(r, c, k));
    }
  return sum / count;
}

TEST_F(Stellarium, ShowsTheTextureAsItIsWhereOurCameraHasIt) {
  for (const auto& look : {in_umbra, partial}) {
    bake(look, "--view Filmic");
    const double radius = radius_px(camera_of(look));
    const auto frame = disc_alone(shown(), radius), reference = expected(look);
    const auto moved = shift(luminances(frame), luminances(reference));
    const double steps = mean_steps(frame, reference, radius);
    fmt::print("{}: {:.2f} px, {:.2f} steps of 255\n", look.instant, glm::length(moved), steps);
    EXPECT_LT(glm::length(moved), 0.3) << "another ephemeris, and 100 facets around: 0.12 px here";
    EXPECT_LT(steps, 1) << "a quarter of a step of rounding, and texels filtered otherwise";
    EXPECT_GT(mean_steps(end_to_end::mirrored(frame), reference, radius), 5) << "or all were alike";
  }
}

TEST_F(Stellarium, WouldPaintAShadowOfItsOwn) {
  bake(in_umbra, "--view Filmic");
  std::filesystem::remove(here("moon.stellarium/data/shaders/planet.frag"));
  const double radius = radius_px(camera_of(in_umbra));
  EXPECT_GT(mean_steps(disc_alone(shown(), radius), expected(in_umbra), radius), 10);
}

}  // namespace coppermoon::hand_off::stellarium_test
