// SPDX-License-Identifier: MIT
#include "verbs/flags/named_files.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace coppermoon::verbs::named_files_test {

using enum colour::WorkingSpace;

TEST(SpaceOfAFile, IsAsItsNameOrTheFlagSays) {
  EXPECT_EQ(space_for("moon_acescg.exr", {}), acescg);
  EXPECT_EQ(space_for("moon_acescg.exr", acescg), acescg);
  EXPECT_EQ(space_for("moon.exr", acescg), acescg);
  EXPECT_EQ(space_for("acescg/moon.exr", {}), std::nullopt) << "a folder says nothing";
  EXPECT_ERROR(space_for("moon_acescg.exr", linear_rec709),
               "space = lin_rec709, allowed acescg as its name says, or no --space");
}

TEST(SpaceOfAFile, IsSaidWhereItsNameSeemsToSayAnother) {
  const auto said = [](const char* file) {
    testing::internal::CaptureStderr();
    say_space_of(file, linear_rec709, "; mend it");
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ(said("moon_aces.exr"),
            "coppermoon: moon_aces.exr: is lin_rec709, which its name does not say; mend it\n");
  EXPECT_NE(said("ring_acescg.exr"), "");
  for (const char* file : {"moon.exr", "moon_lin_rec709.exr", "aces/moon.exr"})
    EXPECT_EQ(said(file), "");
}

}  // namespace coppermoon::verbs::named_files_test
