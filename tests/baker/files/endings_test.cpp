// SPDX-License-Identifier: MIT
#include "files/endings.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace endings_test {

using namespace coppermoon::files;

constexpr std::array formats{Ending{".exr", "scene-linear"}, Ending{".png", ""}};

TEST(Endings, AreSaidWithWhatTheyStandFor) {
  EXPECT_EQ(in_words(formats), ".exr (scene-linear), .png");
  EXPECT_EQ(&format_of("folder.tif/a.b.png", formats, "a picture"), &formats[1]);
  for (const char* other : {"a.tif", "png", ".png", "a.png/", "a.PNG"})
    EXPECT_ERROR(format_of(other, formats, "a picture"),
                 std::string(other) + ": a picture ends in .exr (scene-linear), .png");
}

}  // namespace endings_test
