// SPDX-License-Identifier: MIT
// A film of a POV-Ray scene of the user's own.
#include <algorithm>
#include <map>

#include "support/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end::film_scene_test {

namespace fs = std::filesystem;

/// The left half shows numbers of the frame, in a colour of an include beside the scene; the right half the sky.
constexpr const char* scene = R"(#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "moon.inc"
#include "eclipse_stars.inc"
#include "colour.inc"
#include "functions.inc"
camera { location 0 direction z right x up y angle 40 look_at Coppermoon_Direction(20, Moon_Azimuth) }
Eclipsed_Sky(1)
object { Eclipsed_Moon(1, 1e5) }
Eclipsed_Moonlight(1)
Eclipsed_Stars(0, 1, 2e5)
box { <-9, -9, 9.9>, <0, 9, 10> pigment { rgb Colour*<frame_number, clock, final_frame> }
  finish { emission 1 } rotate x*(-20) rotate y*Moon_Azimuth }
)";

class FilmScene : public ProgramTest {
 protected:
  FilmScene() {
    fs::create_directory(here("my scenes"));
    file("my scenes/tiny.pov", scene);
    file("my scenes/colour.inc", "#declare Colour = 8;\n");
    file("my scenes/moon.inc", "an older one\n");
  }

  /// A film of two frames, or of more words.
  Outcome film(const Words& more = {}) const {
    Words words = "animate 2025-09-07 -o film --at Berlin";
    words += "--scene 'my scenes/tiny.pov' --width 64 --height 48";
    words += "--texture-width 64 --atmosphere undated";
    words += "--make frames,pictures" + more;
    if (std::ranges::find(more, "--frames") == more.end()) words += "--frames 2";
    return coppermoon(words);
  }

  texture::Image frame(const char* number, const std::string& folder = "film") const {
    return texture::read_image(here(folder + "/frame_lin_rec709." + number + ".exr"));
  }

  auto files() const { return contents(here("film")); }
};

const std::string begins_at = "coppermoon: from moonrise, 17:35 UTC, to P4, 20:55 UTC\n",
                  said = begins_at +
                         "coppermoon: 2025-09-07T17:35:53Z: the Moon cannot be seen in its sky; it "
                         "can from 2025-09-07T18:07:47Z\n";

TEST_F(FilmScene, IsRenderedWithTheMoonOfEachFrameGoesOnWhereItWasStoppedAndSaysItsFaults) {
  const auto made = film();
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.err, said) << "that it begins at moonrise";
  const auto first = frame("0001"), last = frame("0002");
  for (const auto* image : {&first, &last}) {
    const bool begins = image == &first;
    EXPECT_EQ((*image)(24, 16, 0), begins ? 8 : 16) << "frame_number";
    EXPECT_EQ((*image)(24, 16, 1), begins ? 0 : 8) << "clock";
    EXPECT_EQ((*image)(24, 16, 2), 16) << "final_frame";
    EXPECT_GT((*image)(24, 48, 2), 0) << "the sky";
  }
  EXPECT_GT(first(24, 48, 2), 100 * last(24, 48, 2)) << "dusk, and night";
  for (const auto& name : listing()) {
    EXPECT_FALSE(name.starts_with("tmp/")) << name << ": is left";
    EXPECT_FALSE(name.starts_with("here/my scenes/eclipse")) << name << ": is written";
  }
  const auto bytes = files();
  fs::remove(here("film/frame_lin_rec709.0002.exr"));
  const auto again = film();
  EXPECT_SAYS(again.out, "1 frames made, 1 kept");
  EXPECT_EQ(files(), bytes);
  file("my scenes/colour.inc", "#declare Colour = 4;\n");
  const auto changed = film();
  EXPECT_EQ(changed.status, 1);
  EXPECT_EQ(changed.err, said + std::string("coppermoon: film: holds a film made with other "
                                            "contents of scene (frame.0001.png and 3 more), "
                                            "allowed another folder, or --replace\n"));
  EXPECT_EQ(film("--replace --range 1").status, 0);
  EXPECT_EQ(frame("0001")(24, 16, 0), 4);
  file("my scenes/colour.inc", "\n#declare Colour = Green;\n");
  const auto broken = film("--replace --range 2");
  EXPECT_EQ(broken.status, 1);
  EXPECT_TRUE(broken.err.starts_with(
      said + std::string("coppermoon: my scenes/tiny.pov: frame 2: povray: File "
                         "'scene_folder/colour.inc' line 2: Parse Error: ")))
      << broken.err;
  EXPECT_EQ(std::ranges::count(broken.err, '\n'), 3) << broken.err;
}

TEST_F(FilmScene, ShowsALandscapeBeforeMoonriseAndOneWithoutStars) {
  // the one frame of a film has a clock, too
  const auto made = film("--from 2025-09-07T17:00Z --frames 1 --stars off");
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(frame("0001")(24, 16, 1), 0) << "clock";
  EXPECT_GT(frame("0001")(24, 48, 2), 0) << "the sky";
}

TEST_F(FilmScene, SaysWhichOptionsItHasNoUseFor) {
  const auto listed = film("--field 3 --mount horizon --dry-run");
  EXPECT_EQ(listed.status, 0) << listed.err;
  EXPECT_EQ(listed.err, "coppermoon: --mount, --field: no effect beside --scene\n" + begins_at);
}

}  // namespace coppermoon::end_to_end::film_scene_test
