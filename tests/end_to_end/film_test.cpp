// SPDX-License-Identifier: MIT
// The whole eclipse of 2018 July 27, from first contact with the penumbra to the last, as 240 frames.
#include <fmt/format.h>

#include "end_to_end/luminance.h"
#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::film_test {

constexpr std::size_t frames = 240;

/// What the eye sees of a frame: its stops, those of its exposure, and which half is the brighter.
struct Seen {
  double mean_log = 0, exposure = 0, left = 0, right = 0;
};

/// Over the disc but for its rim, whose pixels are partly sky.
Seen seen_in(const std::filesystem::path& path) {
  const auto image = texture::read_image(path);
  const double middle_x = static_cast<double>(image.width) / 2,
               middle_y = static_cast<double>(image.height) / 2;
  constexpr double radius = 0.9 * 30 * 0.26 / 0.45;  // pixels: 60 of them are 0.9 degrees
  Seen seen{.exposure = std::log2(std::stod(*texture::read_attribute(path, "expTime")))};
  int pixels = 0;
  for (std::size_t r = 0; r < image.height; ++r)
    for (std::size_t c = 0; c < image.width; ++c) {
      const double x = static_cast<double>(c) + 0.5 - middle_x,
                   y = static_cast<double>(r) + 0.5 - middle_y;
      if (std::hypot(x, y) > radius) continue;
      const double light = luminance(image, r, c);
      EXPECT_GT(light, 0) << path;
      seen.mean_log += std::log2(light);
      (x < 0 ? seen.left : seen.right) += light;
      ++pixels;
    }
  seen.mean_log /= pixels;
  return seen;
}

double largest_bend(const std::vector<double>& values) {
  double largest = 0;
  for (std::size_t i = 2; i < values.size(); ++i)
    largest = std::max(largest, std::abs(values[i] - 2 * values[i - 1] + values[i - 2]));
  return largest;
}

class Film : public ProgramTest {};

TEST_F(Film, OfAWholeEclipseDoesNotFlickerOrPop) {
  expect_done(
      coppermoon("animate 2018-07-27 --frames 240 --make frames --field 0.9 --width 60 --height 40 "
                 "--texture-width 128 --albedo-map built-in -o film"));
  std::vector<Seen> all;
  for (std::size_t frame = 1; frame <= frames; ++frame)
    all.push_back(seen_in(here(fmt::format("film/frame_lin_rec709.{:04}.exr", frame))));
  std::vector<double> light, exposure, shown;
  for (const auto& seen : all) {
    light.push_back(seen.mean_log);
    exposure.push_back(seen.exposure);
    shown.push_back(seen.mean_log + seen.exposure);
  }
  EXPECT_WITHIN(largest_bend(light), 0, 0.06,
                "stops: 4 % from one frame to the next is what an eye just sees flicker at");
  EXPECT_WITHIN(largest_bend(exposure), 0, 0.11,
                "stops: a third of the finest step on a camera's dial");
  EXPECT_WITHIN(largest_bend(shown), 0, 0.11, "stops: the same");
  fmt::print(
      "largest bend from frame to frame [stops]: light {:.3f}, exposure {:.3f}, shown {:.3f}\n",
      largest_bend(light), largest_bend(exposure), largest_bend(shown));
  // the Moon goes east, which is left where north is up: that side is dark first and bright first
  EXPECT_LT(all[80].left, 0.5 * all[80].right) << "half way into the umbra";
  EXPECT_GT(all[160].left, 2 * all[160].right) << "half way out of it";
  EXPECT_GT(all.front().mean_log - all[120].mean_log, 10) << "stops: it was a total one";
  EXPECT_WITHIN(all.front().mean_log, all.back().mean_log, 0.2, "stops: full Moons both");
}

}  // namespace coppermoon::end_to_end::film_test
