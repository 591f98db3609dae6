// SPDX-License-Identifier: MIT
#include "povray_scenes/moon_scene.h"

#include "files/own_file.h"
#include "povray_scenes/folder.h"
#include "povray_scenes/meridian.h"
#include "support/testing.h"

namespace coppermoon::povray_scenes::moon_scene_test {

using algebra::Error;

MoonScene plain_scene() {
  return {.camera = {{221.25, -3.5, 7.125}, {0, 0.25, 1}, algebra::degrees(0.625), 640, 480},
          .texture = "moon.0001.exr"};
}

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ToPov, ExchangesYAndZForPovRaysLeftHandedAxes) {
  EXPECT_TRUE(says(to_pov(plain_scene()), "location <221.25, 7.125, -3.5>"));
  EXPECT_TRUE(says(to_pov(plain_scene()), "rotate y*180"));
}

TEST(ToPov, SetsTheSkyBeforeItLooks) {
  const auto text = to_pov(plain_scene());
  const auto sky = text.find("sky <"), look_at = text.find("look_at");
  ASSERT_NE(sky, std::string::npos);
  EXPECT_LT(sky, look_at);
}

TEST(ToPov, IsLitByTheTextureAlone) {
  const auto text = to_pov(plain_scene());
  EXPECT_TRUE(says(text, "finish { ambient 0 diffuse 0 emission 1 }"));
  EXPECT_TRUE(says(text, "assumed_gamma 1.0"));
  EXPECT_TRUE(says(text, "exr \"moon.0001.exr\" map_type 1 interpolate 2"));
  EXPECT_FALSE(says(text, "light_source"));
  EXPECT_FALSE(says(text, " gamma "));  // on an EXR that keyword decodes what is linear already
}

TEST(ToPov, NeedsNothingInstalled) { EXPECT_FALSE(says(to_pov(plain_scene()), "#include")); }

TEST(ToPov, WritesNumbersThatReadBackTheSame) {
  auto scene = plain_scene();
  scene.camera.position.x = 221.34567890123456;
  const auto text = to_pov(scene);
  const auto at = text.find("location <") + 10;
  EXPECT_EQ(std::stod(text.substr(at)), scene.camera.position.x);
}

TEST(ToPov, SquashesTheTexturedSphereTowardsTheZenith) {
  auto scene = plain_scene();
  scene.camera.position = {221.25, 0, 0};
  EXPECT_FALSE(says(to_pov(scene), "matrix"));
  scene.camera.flattening = 0.875;
  scene.camera.zenith = {0, 0, 1};  // y in POV-Ray's axes
  EXPECT_TRUE(says(to_pov(scene),
                   "  rotate y*180\n  matrix <1, 0, 0, 0, 0.875, 0, 0, 0, 1, 0, 0, 0>\n}\n"));
}

TEST(ToPov, RefusesNamesThatPovRayDoesNotFindOrRead) {
  for (const char* name : {"", ".exr", "moon.png", "mönd.exr", "a/moon.exr", "../moon.exr",
                           "a\"b.exr", "a\\b.exr", "a\nb.exr"}) {
    auto scene = plain_scene();
    scene.texture = name;
    EXPECT_THROW(to_pov(scene), Error) << name;
    EXPECT_THROW(to_ini(scene), Error) << name;
  }
}

TEST(ToPov, RefusesAFieldTooWideForPovRay) {
  auto scene = plain_scene();
  scene.camera.horizontal_field = algebra::degrees(180);
  EXPECT_THROW(to_pov(scene), Error);
}

TEST(ToIni, SupersamplesHoweverDarkAndRepeats) {
  const auto text = to_ini(plain_scene());
  EXPECT_TRUE(says(text, "Antialias=on\nAntialias_Threshold=0.0\nAntialias_Gamma=1.0\n"));
  EXPECT_TRUE(says(text, "Sampling_Method=2\nAntialias_Depth=2\nJitter=off\n"));
}

TEST(ToIni, AsksForALinearFrameOfTheCamerasSize) {
  const auto text = to_ini(plain_scene());
  EXPECT_TRUE(says(text, "Width=640\nHeight=480\n"));
  EXPECT_TRUE(says(text, "Output_File_Type=E\n"));
  EXPECT_TRUE(says(text, "Output_File_Name=frame.exr\n"));
}

TEST(ToIni, NamesNoRangeOfFrames) {
  EXPECT_FALSE(says(to_ini(plain_scene()), "_Frame="));
  EXPECT_FALSE(says(to_ini(plain_scene()), "Clock"));
}

TEST(WriteScene, MakesTheFolderAndLeavesTwoFilesInIt) {
  const TemporaryFolder parent;
  const auto folder = parent.path / "ä scene";
  write_scene(folder, plain_scene());
  EXPECT_EQ(contents(folder / "eclipse.pov"), files::stamped(to_pov(plain_scene()), "//"));
  EXPECT_EQ(contents(folder / "eclipse.ini"), files::stamped(to_ini(plain_scene()), ";"));
  EXPECT_EQ(files_in(folder), 2);
}

TEST(WriteScene, WritesOverAnEarlierScene) {
  const TemporaryFolder parent;
  write_scene(parent.path, plain_scene());
  auto other = plain_scene();
  other.camera.width = 123;
  write_scene(parent.path, other);
  EXPECT_TRUE(says(contents(parent.path / "eclipse.ini"), "Width=123\n"));
}

TEST(WriteScene, KnowsASceneThatWasChanged) {
  const TemporaryFolder parent;
  EXPECT_NO_THROW(require_scene_place(parent.path / "none"));
  write_scene(parent.path, plain_scene());
  EXPECT_NO_THROW(require_scene_place(parent.path));
  std::ofstream(parent.path / "eclipse.ini", std::ios::app) << "Width=1920\n";
  EXPECT_THROW(require_scene_place(parent.path), Error);
}

TEST(WriteScene, RefusesAFolderWithoutAParent) {
  const TemporaryFolder parent;
  EXPECT_THROW(write_scene(parent.path / "none" / "scene", plain_scene()), Error);
  EXPECT_EQ(files_in(parent.path), 0);
}

TEST(WriteScene, LeavesNothingHalfWritten) {
  const TemporaryFolder parent;
  std::filesystem::create_directories(parent.path / "eclipse.pov" / "in the way");
  EXPECT_THROW(write_scene(parent.path, plain_scene()), Error);
  EXPECT_EQ(files_in(parent.path), 1);
}

}  // namespace coppermoon::povray_scenes::moon_scene_test
