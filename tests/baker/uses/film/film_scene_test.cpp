// SPDX-License-Identifier: MIT
#include <unistd.h>

#include "support/testing.h"
#include "uses/film/film_scene.h"

namespace coppermoon::uses::film_scene_test {

namespace fs = std::filesystem;

class FilmScene : public testing::Test {
 protected:
  FilmScene() {
    auto name = (fs::temp_directory_path() / "coppermoon-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    write("lake.pov", "// 12\" of water\n#include \"moon.inc\"\n#include \"parts/hills.inc\"\n");
    fs::create_directory(folder_ / "parts");
    write("parts/hills.inc", "image_map { png \"rock.png\" }\n");
    write("parts/rock.png", "grey");
  }
  ~FilmScene() override { fs::remove_all(folder_); }

  void write(const char* name, const char* text) const { std::ofstream(folder_ / name) << text; }
  std::string contents() const { return scene_contents(folder_ / "lake.pov"); }

  fs::path folder_;
};

TEST_F(FilmScene, HasTheContentsOfTheFilesThatItNames) {
  const auto before = contents();
  for (const auto* ours : {"moon.inc", "frame.0001.png"}) {
    write(ours, "of another moment");
    EXPECT_EQ(contents(), before) << ours;
  }
  for (const auto* theirs : {"parts/rock.png", "parts/hills.inc", "lake.pov"}) {
    const auto last = contents();
    std::ofstream(folder_ / theirs, std::ios::app) << " ";
    EXPECT_NE(contents(), last) << theirs;
  }
}

TEST_F(FilmScene, IsRefusedWhereItCannotBeRendered) {
  Film film;
  const auto refusal = [&] { return refusal_of([&] { require_scene(film); }); };
  film.scene = "lake.png";
  EXPECT_EQ(refusal(), "lake.png: a scene of POV-Ray ends in .pov");
  film.scene = folder_ / "sea.pov";
  EXPECT_EQ(refusal(), film.scene.string() + ": not found");
  film.scene = folder_ / "lake.pov";
  EXPECT_EQ(refusal(), film.scene.string() + ": has a sky, allowed with a place of the observer");
  film.view.observer = almanac::Observer{};
  EXPECT_EQ(refusal(), "");
  film.products.textures = true;
  EXPECT_EQ(refusal(),
            film.scene.string() + ": shows frames and pictures, allowed without textures");
}

}  // namespace coppermoon::uses::film_scene_test
