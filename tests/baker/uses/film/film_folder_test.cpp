// SPDX-License-Identifier: MIT
#include <unistd.h>

#include "files/own_file.h"
#include "support/testing.h"
#include "texture/write_image.h"
#include "uses/film/film_folder.h"

namespace coppermoon::uses::film_folder_test {

namespace fs = std::filesystem;

/// A film of three pictures, and the record of another.
class FolderOfAFilm : public testing::Test {
 protected:
  FolderOfAFilm() {
    auto name = (fs::temp_directory_path() / "coppermoon-XXXXXX").string();
    film_.folder = ::mkdtemp(name.data());
    film_.products.pictures = true;
    film_.moments.frames.resize(3);
    film_.record.recipe = request::recipe_in("iso = 800\n");
    film_.record.way_out = ", or sleep";
  }
  ~FolderOfAFilm() override { fs::remove_all(film_.folder); }

  /// Writes a picture as that of a frame, of a film with that record.
  static void write(const fs::path& picture, int frame, const FilmRecord& record) {
    auto header = record.frame_header();
    header["coppermoon:frame"] = std::to_string(frame);
    texture::write_png(picture, texture::Image(2, 2, {"R", "G", "B"}), 8, header);
  }
  void write(const fs::path& picture, int frame) const { write(picture, frame, film_.record); }

  Film film_;
  FilmRecord foreign_{.recipe = request::recipe_in("iso = 100\n")};
};

TEST_F(FolderOfAFilm, HoldsAFrameThatIsWholeAndItsOwn) {
  write(film_.picture(1), 1);
  write(film_.picture(2), 1);
  EXPECT_TRUE(is_made(film_, 1));
  EXPECT_FALSE(is_made(film_, 2)) << "its header has another number";
  EXPECT_FALSE(is_made(film_, 3)) << "it is not there";
  fs::resize_file(film_.picture(1), fs::file_size(film_.picture(1)) - 20);
  EXPECT_FALSE(is_made(film_, 1)) << "it is cut off";
}

TEST_F(FolderOfAFilm, IsOneFilms) {
  write(film_.picture(1), 1);
  EXPECT_NO_THROW(require_own(film_, false));
  write(film_.picture(1), 1, foreign_);
  EXPECT_FALSE(is_made(film_, 1));
  EXPECT_EQ(refusal_of([&] { require_own(film_, false); }),
            film_.folder.string() +
                ": holds a film made with iso = 100, asked 800 (frame.0001.png), "
                "allowed another folder, or sleep");
}

TEST_F(FolderOfAFilm, IsOneFilmsForAsLongAsItIsMade) {
  auto another = film_;
  another.record = foreign_;
  {
    const FilmClaim first_shard(film_), second_shard(film_);
    EXPECT_THROW(FilmClaim{another}, algebra::Error);
    EXPECT_NO_THROW(FilmClaim{film_}) << "who was refused keeps nobody out";
  }
  EXPECT_NO_THROW(FilmClaim{another});
}

TEST_F(FolderOfAFilm, LosesFramesOfAnotherThatItHasNoNumberFor) {
  const auto fourth = film_.folder / "frame.0004.png";
  write(film_.picture(1), 1);
  write(fourth, 4, foreign_);
  require_own(film_, true);
  EXPECT_FALSE(fs::exists(fourth));
  EXPECT_TRUE(fs::exists(film_.picture(1)));
}

TEST_F(FolderOfAFilm, IsNotWrittenThroughLinks) {
  const auto precious = film_.folder / "precious.txt";
  std::ofstream(precious) << "mine";
  for (const auto& link : {film_.picture(2), film_.folder / "eclipse.light"}) {
    fs::create_symlink("precious.txt", link);
    EXPECT_FALSE(is_made(film_, 2));
    EXPECT_THROW(require_own(film_, false), algebra::Error) << link;
    EXPECT_TRUE(fs::is_symlink(link));
    require_own(film_, true);
    EXPECT_FALSE(fs::is_symlink(link));
    EXPECT_TRUE(fs::exists(precious));
  }
  write(film_.folder / "elsewhere.png", 1);
  fs::create_symlink("elsewhere.png", film_.picture(1));
  EXPECT_FALSE(is_made(film_, 1)) << "whatever stands there";
}

TEST_F(FolderOfAFilm, KeepsASceneThatWasChanged) {
  film_.products = {.textures = true, .scenes = true};
  const auto scene = film_.folder / "eclipse.pov";
  std::ofstream(scene) << "// my own\n";
  EXPECT_THROW(require_own(film_, false), algebra::Error);
  std::ofstream(scene) << files::stamped("// a scene\n", "//");
  EXPECT_NO_THROW(require_own(film_, false));
}

TEST_F(FolderOfAFilm, WithoutARecordHoldsNothingOfIt) {
  write(film_.picture(1), 1);
  film_.record = {};
  EXPECT_FALSE(is_made(film_, 1));
  EXPECT_THROW(require_own(film_, false), algebra::Error);
}

}  // namespace coppermoon::uses::film_folder_test
