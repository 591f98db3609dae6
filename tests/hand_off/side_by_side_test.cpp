// SPDX-License-Identifier: MIT
// One texture, one camera, three renderers: POV-Ray, Blender, and rays through each pixel. Prints the
// rows of examples/side_by_side.md; $COPPERMOON_FRAMES is a folder that the frames are left in.
#include <fmt/format.h>
#include <cstdlib>

#include "hand_off/agreement.h"
#include "hand_off/blender.h"
#include "hand_off/reference_projection.h"
#include "povray_scenes/moon_scene.h"
#include "povray_scenes/render.h"
#include "support/testing.h"

namespace coppermoon::hand_off::side_by_side_test {

struct Frame {
  std::string name;
  texture::Image image;
};

class SideBySide : public BlenderTest {
 protected:
  SideBySide() {
    const auto size = std::to_string(side);
    expect_done(coppermoon(
        words_of("scene {} --at {} --flattening off --field {} --width {} --height {} -o scene",
                 look.instant, at(look.observer), field_deg, size, size)));
  }

  /// POV-Ray's pixels are means of (2^(depth - 1) + 1)² rays, those on their edges counting less.
  Frame by_povray(int depth) const {
    const auto ini = here("scene") / povray_scenes::settings_file;
    std::ofstream(ini, std::ios::app) << "Antialias_Depth=" << depth << "\n";
    const int rays = (1 << (depth - 1)) + 1;
    return {fmt::format("POV-Ray, {0} × {0} rays", rays),
            texture::read_image(povray_scenes::render(here("scene")))};
  }

  Frame by_blender() const {
    return {"Blender, 256 rays", rendered(map, look.up, "scene.cycles.samples = 256\n")};
  }

  Frame by_rays() const {
    return {"reference", reference_projection(texture::read_image(here(map)), look.camera())};
  }

  static void keep(const std::string& name, const Frame& frame) {
    if (const char* kept = std::getenv("COPPERMOON_FRAMES"))
      texture::write_exr(std::filesystem::path(kept) / (name + ".exr"), frame.image,
                         {{"coppermoon:colour_space", std::string("lin_rec709")}});
  }

  std::string map = "scene/moon_lin_rec709.exr";
  Look look = from_the_north(povray_scenes::Up::celestial_north);
};

/// Prints what it checks: at most so large a part of the pixels more than 2 px inside the limb
/// differs by more than 1 %.
void expect_agreement(const Frame& one, const Frame& other, double radius, double part = 0.01) {
  const auto frame = luminances(one.image), reference = luminances(other.image);
  const double differing = part_that_differs(frame, reference, radius, 0.01);
  const double disc = total(frame) / total(reference) - 1;
  const double centre = glm::distance(centroid(frame), centroid(reference));
  const double moved = glm::length(shift(frame, reference));
  fmt::print("| {} | {} | {:.2f} % | {:.4f} % | {:.4f} | {:.4f} |\n", one.name, other.name,
             100 * (1 - differing), 100 * disc, centre, moved);
  EXPECT_LT(differing, part);
  EXPECT_WITHIN(disc, 0, 0.01, "what is asked of a hand-off");
  EXPECT_LT(centre, 0.5);
  EXPECT_LT(moved, 0.5);
}

TEST_F(SideBySide, ThreeRenderersShowTheSameMoon) {
  const auto coarse = by_povray(2), fine = by_povray(5), blender = by_blender(),
             reference = by_rays();
  keep("povray", fine);
  keep("blender", blender);
  keep("reference", reference);
  const double radius = radius_px(look.camera());
  expect_agreement(blender, reference, radius);
  expect_agreement(fine, reference, radius);
  expect_agreement(blender, fine, radius);
  // As coppermoon's own scenes are: 5 rays a side, two of them on the edges, reach out further.
  expect_agreement(coarse, reference, radius, 0.1);
}

}  // namespace coppermoon::hand_off::side_by_side_test
