// SPDX-License-Identifier: MIT
#include "files/own_file.h"

#include "baker/texture/scratch_folder.h"
#include "files/whole_file.h"
#include "support/testing.h"

namespace own_file_test {

using coppermoon::files::is_stamped;
using coppermoon::files::require_no_link;
using coppermoon::files::require_stamped;
using coppermoon::files::stamped;
using coppermoon::files::write_whole;

using OwnFile = ScratchFolder;

TEST_F(OwnFile, EndsInItsFingerprint) {
  const auto path = in_folder("a.inc");
  write_whole(path, stamped("one\ntwo\n", "//"));
  EXPECT_TRUE(bytes_of(path).starts_with("one\ntwo\n// as coppermoon wrote it: "));
  EXPECT_TRUE(is_stamped(path));
  EXPECT_NO_THROW(require_stamped(path));
  EXPECT_NO_THROW(require_stamped(in_folder("none.inc")));
  EXPECT_TRUE(is_stamped(file("a.html", stamped("one\n", "<!--", " -->"))));
  EXPECT_FALSE(is_stamped(file("a.html", stamped("one\n", "<!--", " -->") + "two\n")));
}

TEST_F(OwnFile, ThatWasChangedIsNotOurs) {
  const auto ours = stamped("one\ntwo\n", "//");
  auto changed = ours;
  changed[1] = 'N';
  for (const auto& bytes : {changed, ours + "three\n", "zero\n" + ours, std::string("one\n"),
                            std::string(), ours.substr(0, ours.size() - 2)}) {
    const auto path = file("a.inc", bytes);
    EXPECT_FALSE(is_stamped(path)) << bytes;
    EXPECT_ERROR(require_stamped(path), "a.inc: is not as coppermoon wrote it");
    EXPECT_EQ(bytes_of(path), bytes);
  }
}

TEST_F(OwnFile, IsNoLink) {
  write_whole(in_folder("ours"), stamped("one\n", ";"));
  std::filesystem::create_symlink("ours", in_folder("link"));
  std::filesystem::create_symlink("nowhere", in_folder("dangling"));
  EXPECT_FALSE(is_stamped(in_folder("link")));
  for (const char* link : {"link", "dangling"})
    EXPECT_ERROR(require_stamped(in_folder(link)), "is a link");
  EXPECT_NO_THROW(require_no_link(in_folder("ours")));
}

}  // namespace own_file_test
