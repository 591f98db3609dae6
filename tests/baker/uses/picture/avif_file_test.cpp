// SPDX-License-Identifier: MIT
#include "uses/picture/picture_files.h"

#include "support/helper_folder.h"
#include "support/testing.h"

namespace coppermoon::uses::avif_file_test {

using AvifFile = HelperFolder;

TEST_F(AvifFile, ThatItsProgramDoesNotWriteIsSaid) {
  stand_in("avifenc", "exit 0");
  const texture::Image picture(2, 2, {"R", "G", "B"});
  EXPECT_EQ(refusal_of([&] { write_avif(here() / "a.avif", picture); }),
            "avifenc: ended without a result");
  EXPECT_FALSE(std::filesystem::exists(here() / "a.avif"));
}

TEST_F(AvifFile, ThatItsProgramCutsOffIsSaid) {
  stand_in("avifenc", "printf '\\0\\0\\0\\20ftypavif' > picture.avif");
  const texture::Image picture(2, 2, {"R", "G", "B"});
  EXPECT_EQ(refusal_of([&] { write_avif(here() / "a.avif", picture); }),
            "avifenc: its file is cut off after 12 bytes; is the disk full?");
  EXPECT_FALSE(std::filesystem::exists(here() / "a.avif"));
}

}  // namespace coppermoon::uses::avif_file_test
