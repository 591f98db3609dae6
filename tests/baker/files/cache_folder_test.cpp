// SPDX-License-Identifier: MIT
#include "files/cache_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <atomic>
#include <cstdlib>
#include <thread>

#include "baker/texture/scratch_folder.h"
#include "files/lock.h"
#include "support/testing.h"

namespace cache_folder_test {

namespace fs = std::filesystem;
using coppermoon::algebra::Error;
using coppermoon::files::is_users_own;
using coppermoon::files::lock_file;
using coppermoon::files::make_private_folder;

using CacheFolder = ScratchFolder;

constexpr uid_t other_user = 65534;

mode_t permissions_of(const fs::path& path) {
  struct stat about {};
  ::stat(path.c_str(), &about);
  return about.st_mode & 07777;
}

void not_asked() { ADD_FAILURE() << "it waits"; }

TEST_F(CacheFolder, IsMadeForItsUserAlone) {
  for (const char* name : {"a", "above/b", "above/c/"}) {
    make_private_folder(in_folder(name));
    EXPECT_EQ(permissions_of(in_folder(name)), 0700u) << name;
    make_private_folder(in_folder(name));
  }
  ::chmod(in_folder("a").c_str(), 0755);
  make_private_folder(in_folder("a"));
  EXPECT_EQ(permissions_of(in_folder("a")), 0755u) << "as its user left it";
  EXPECT_THROW(make_private_folder(file("file", "")), Error);
  EXPECT_THROW(make_private_folder(in_folder("file/below")), Error);
}

TEST_F(CacheFolder, TrustsNothingOfAnotherUser) {
  const auto mine = file("mine", "x"), theirs = file("theirs", "x");
  fs::create_symlink(mine, in_folder("link"));
  EXPECT_TRUE(is_users_own(mine));
  for (const char* name : {"link", "absent", "."}) EXPECT_FALSE(is_users_own(in_folder(name)));
  if (::chown(theirs.c_str(), other_user, other_user) != 0)
    GTEST_SKIP() << "files are given by root alone";
  EXPECT_FALSE(is_users_own(theirs));
  fs::create_directory(in_folder("their_folder"));
  fs::create_directory_symlink(in_folder("their_folder"), in_folder("way_there"));
  ASSERT_EQ(::chown(in_folder("their_folder").c_str(), other_user, other_user), 0);
  EXPECT_THROW(make_private_folder(in_folder("their_folder")), Error);
  EXPECT_THROW(make_private_folder(in_folder("way_there")), Error);
}

TEST_F(CacheFolder, ThatCannotBeMadeNamesItsVariable) {
  const auto taken = file("taken", "by a file");
  ::setenv("COPPERMOON_CACHE", (taken / "kept").c_str(), 1);
  EXPECT_ERROR(make_private_folder(coppermoon::files::usual_cache()),
               "; the variable COPPERMOON_CACHE may name another");
  ::unsetenv("COPPERMOON_CACHE");
}

TEST_F(CacheFolder, LocksOneFileForOneAtATime) {
  auto first = lock_file(in_folder("a.tx"), not_asked);
  const auto other = lock_file(in_folder("b.tx"), not_asked);
  EXPECT_EQ(permissions_of(in_folder(".a.tx.lock")), 0600u);
  std::atomic<bool> free = false, asked = false, had = false;
  {
    std::jthread waiting([&] {
      const auto second = lock_file(in_folder("a.tx"), [&] { asked = true; });
      EXPECT_TRUE(free);
      had = true;
    });
    while (!asked) std::this_thread::yield();
    free = true;
    first.close();
  }
  EXPECT_TRUE(had);
}

TEST_F(CacheFolder, WaitsForNobodyWhoMayOnlyReadIt) {
  const int reader = ::open(in_folder(".").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(reader, LOCK_EX), 0);
  lock_file(in_folder("a.tx"), not_asked).close();
  ::close(reader);
  const int stranger = ::open(in_folder(".b.tx.lock").c_str(), O_RDWR | O_CREAT, 0666);
  ASSERT_EQ(::flock(stranger, LOCK_EX), 0);
  if (::fchown(stranger, other_user, other_user) == 0)
    lock_file(in_folder("b.tx"), not_asked).close();
  ::close(stranger);
}

}  // namespace cache_folder_test
