// SPDX-License-Identifier: MIT
#include "texture/write_stellarium.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"
#include "texture/read_image.h"
#include "texture/write_image.h"

namespace write_stellarium_test {

using namespace coppermoon::texture;
using coppermoon::algebra::degrees;
using coppermoon::algebra::metres;

using WriteStellarium = ScratchFolder;

const StellariumSight sight{coppermoon::almanac::instant_from_utc("2018-07-27T20:21:45.4Z"),
                            {degrees(-1.28), degrees(36.82), metres(1684)}};

Image picture() {
  Image image(4, 2, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = static_cast<float>(i) / 255;
  return image;
}

void write_folder(const std::filesystem::path& folder, const Image& image,
                  const Attributes& attributes) {
  write_stellarium(folder, {image.width, image.height, image.channels}, rows_of(image), sight,
                   attributes);
}

TEST_F(WriteStellarium, PutsPictureShaderAndScriptWhereItLooksForThem) {
  const auto folder = in_folder("moon.stellarium");
  write_folder(folder, picture(), {{"coppermoon:recipe", std::string("a recipe")}});
  const auto shown = read_image(folder / "textures/moon_4k.jpg");
  for (std::size_t i = 0; i < shown.values.size(); ++i)
    EXPECT_FLOAT_EQ(shown.values[i], picture().values[i]) << "a PNG: without loss";
  EXPECT_EQ(read_attribute(folder / "textures/moon_4k.jpg", "coppermoon:recipe"), "a recipe");
  const auto script = bytes_of(folder / "scripts/startup.ssc");
  for (const auto* part : {"core.setObserverLocation(36.820000, -1.280000, 1684, 0,",
                           "core.setDate(\"2018-07-27T20:21:45\", \"utc\");"})
    EXPECT_SAYS(script, part);
  EXPECT_SAYS(bytes_of(folder / "data/shaders/planet.frag"), "#ifdef IS_MOON");
}

TEST_F(WriteStellarium, OverwritesItsOwnFilesAlone) {
  const auto folder = in_folder("moon.stellarium");
  const auto write = [&] {
    write_folder(folder, picture(), {{"coppermoon:recipe", std::string("a recipe")}});
  };
  write();
  EXPECT_NO_THROW(write());
  for (const char* name : {"scripts/startup.ssc", "data/shaders/planet.frag"}) {
    std::filesystem::rename(folder / name, folder / "ours");
    file(std::string("moon.stellarium/") + name, "// my own\n");
    EXPECT_ERROR(write(), std::string(name) + ": is not as coppermoon wrote it");
    EXPECT_EQ(bytes_of(folder / name), "// my own\n");
    std::filesystem::rename(folder / "ours", folder / name);
  }
  write_png(in_folder("mine.png"), picture(), 8);
  std::filesystem::rename(in_folder("mine.png"), folder / stellarium_picture);
  EXPECT_ERROR(write(), "moon_4k.jpg: is not as coppermoon wrote it");
}

TEST_F(WriteStellarium, FollowsNoLinkToAnotherFolder) {
  std::filesystem::create_directories(in_folder("mine"));
  std::filesystem::create_directories(in_folder("moon.stellarium"));
  for (const char* part : {"scripts", "data"}) {
    std::filesystem::create_symlink("../mine", in_folder("moon.stellarium") / part);
    EXPECT_ERROR(write_folder(in_folder("moon.stellarium"), picture(), {}),
                 std::string(part) + ": is a link");
    std::filesystem::remove(in_folder("moon.stellarium") / part);
  }
  EXPECT_TRUE(std::filesystem::is_empty(in_folder("mine")));
}

TEST_F(WriteStellarium, LeavesNoFolderThatItCannotFill) {
  auto wrong = picture();
  wrong.values[3] = 2;
  EXPECT_ERROR(write_folder(in_folder("moon.stellarium"), wrong, {}), "2");
  EXPECT_EQ(files_in_folder(), 0U);
  EXPECT_ERROR(write_folder(file("taken", "by a file"), picture(), {}),
               "no folder can be made there");
  EXPECT_EQ(bytes_of(in_folder("taken")), "by a file");
}

}  // namespace write_stellarium_test
