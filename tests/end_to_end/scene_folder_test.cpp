// SPDX-License-Identifier: MIT
// A scene is whole: it renders with POV-Ray alone, wherever it is moved.
#include "end_to_end/program.h"
#include "texture/read_image.h"

namespace coppermoon::end_to_end {
namespace {

class SceneFolder : public ProgramTest {
 protected:
  void write_scene() const {
    expect_done(coppermoon({"scene", "2008-02-21T03:26:05Z", "--at", "42.86,-73.77", "--rays", "50",
                            "--albedo-map", "built-in", "--texture-width", "64", "--width", "32",
                            "--height", "24", "-o", "scene"}));
  }
};

TEST_F(SceneFolder, HoldsSceneSettingsAndTexture) {
  write_scene();
  const std::set<std::string> expected{"here/scene", "here/scene/eclipse.ini",
                                       "here/scene/eclipse.pov", "here/scene/moon_lin_rec709.exr"};
  std::set<std::string> found = listing();
  EXPECT_EQ(found, expected);
}

TEST_F(SceneFolder, RendersWithPovrayAloneWhereverItIsMoved) {
  write_scene();
  std::filesystem::rename(here("scene"), here("moved with spaces"));
  const auto outcome = run({"povray", "eclipse.ini"}, {.folder = here("moved with spaces")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto frame = texture::read_image(here("moved with spaces") / "frame.exr");
  EXPECT_EQ(frame.width, 32U);
  EXPECT_EQ(frame.height, 24U);
  EXPECT_GT(frame(12, 16, 0), frame(12, 16, 2)) << "an eclipsed Moon is red";
  EXPECT_GT(frame(12, 16, 0), 0.01F);
  EXPECT_EQ(frame(0, 0, 0), 0.F);
}

TEST_F(SceneFolder, IsWrittenOverAnOldOne) {
  write_scene();
  const auto before = text_of(here("scene/moon_lin_rec709.exr"));
  write_scene();
  EXPECT_EQ(text_of(here("scene/moon_lin_rec709.exr")), before);
}

TEST_F(SceneFolder, IsMadeAgainFromItsTexture) {
  write_scene();
  expect_done(coppermoon({"scene", "scene/moon_lin_rec709.exr", "-o", "again"}));
  for (const char* file : {"moon_lin_rec709.exr", "eclipse.pov", "eclipse.ini"})
    EXPECT_EQ(text_of(here("again") / file), text_of(here("scene") / file)) << file;
}

TEST_F(SceneFolder, OfAStillIsMadeAgainFromItsPicture) {
  const std::vector<std::string> still{"still",        "2008-02-21T03:26:05Z",
                                       "--at",         "42.86,-73.77",
                                       "--albedo-map", "built-in",
                                       "--width",      "32",
                                       "--height",     "24",
                                       "-o",           "still.png"};
  expect_done(coppermoon(still));
  expect_done(coppermoon({"still", "still.png", "-o", "again.png"}));
  EXPECT_EQ(text_of(here("again.png")), text_of(here("still.png")));
}

}  // namespace
}  // namespace coppermoon::end_to_end
