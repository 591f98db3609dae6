// SPDX-License-Identifier: MIT
#include "files/name_to_share.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace name_to_share_test {

using coppermoon::files::name_to_share;
using coppermoon::files::shared_file;

using NameToShare = ScratchFolder;

TEST_F(NameToShare, HasNoFolderOfTheUser) {
  EXPECT_EQ(name_to_share("/home/alice/maps/moon.tif"), "moon.tif");
  EXPECT_EQ(name_to_share("/usr/share/maps/moon.tif"), "/usr/share/maps/moon.tif");
  EXPECT_EQ(name_to_share("/usr/../home/alice/moon.tif"), "moon.tif");
  EXPECT_EQ(name_to_share("maps/moon.tif"), "maps/moon.tif");
  EXPECT_EQ(name_to_share("auto"), "auto");
  const auto here = std::filesystem::current_path();
  EXPECT_EQ(name_to_share(here / "maps/moon.tif"), "maps/moon.tif");
  EXPECT_EQ(name_to_share(here / "../moon.tif"), "moon.tif");
}

TEST_F(NameToShare, IsLookedForBesideTheFileThatHasIt) {
  const auto map = file("moon.tif", "a map");
  EXPECT_EQ(shared_file("moon.tif", in_folder("frame.png")), map);
  EXPECT_EQ(shared_file("none.tif", in_folder("frame.png")), "none.tif");
  EXPECT_EQ(shared_file("/home/alice/moon.tif", in_folder("frame.png")), "/home/alice/moon.tif");
}

}  // namespace name_to_share_test
