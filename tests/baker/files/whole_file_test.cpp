// SPDX-License-Identifier: MIT
#include "files/whole_file.h"

#include <fcntl.h>
#include <sys/inotify.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdarg>
#include <thread>

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace {

bool files_without_names = true;  ///< whether the file system has them

}  // namespace

/// The system's, in whose place the linker puts it.
extern "C" int open(const char* path, int flags, ...) {
  const bool unnamed = (flags & O_TMPFILE) == O_TMPFILE;
  mode_t mode = 0;
  if (unnamed || (flags & O_CREAT) != 0) {
    std::va_list more;
    va_start(more, flags);
    mode = va_arg(more, mode_t);
    va_end(more);
  }
  if (unnamed && !files_without_names) {
    errno = EOPNOTSUPP;
    return -1;
  }
  return ::openat(AT_FDCWD, path, flags, mode);
}

namespace whole_file_test {

using coppermoon::algebra::Error;
using coppermoon::files::require_place_for;
using coppermoon::files::write_whole;

using WholeFile = ScratchFolder;

/// No file may grow beyond so many bytes while this lives: what a full disk looks like to a
/// program.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() { ::setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_;
};

/// Names that appear in a folder while something is done there.
template <class Act>
std::vector<std::string> names_made_in(const std::string& folder, const Act& act) {
  const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  ::inotify_add_watch(watch, folder.c_str(), IN_CREATE | IN_MOVED_TO);
  act();
  alignas(inotify_event) std::array<char, 4096> bytes;
  const auto count = ::read(watch, bytes.data(), bytes.size());
  ::close(watch);
  std::vector<std::string> names;
  for (std::ptrdiff_t at = 0; at < count;) {
    const auto* event = reinterpret_cast<const inotify_event*>(bytes.data() + at);
    names.emplace_back(event->name);
    at += static_cast<std::ptrdiff_t>(sizeof(inotify_event) + event->len);
  }
  return names;
}

TEST_F(WholeFile, ThatIsNewHasNoOtherNameBefore) {
  const std::filesystem::path path = in_folder("new.txt");
  const auto folder = path.parent_path().string();
  EXPECT_EQ(names_made_in(folder, [&] { write_whole(path, "one"); }),
            std::vector<std::string>{"new.txt"});
  // one that replaces another is renamed
  EXPECT_EQ(names_made_in(folder, [&] { write_whole(path, "two"); }).size(), 2);
}

TEST_F(WholeFile, HoldsWhatWasWritten) {
  const auto path = in_folder("a.txt");
  write_whole(path, "one\n");
  EXPECT_EQ(bytes_of(path), "one\n");
  EXPECT_EQ(files_in_folder(), 1);
}

TEST_F(WholeFile, ReplacesAnOldOne) {
  const auto path = file("a.txt", "a much longer old text");
  write_whole(path, "new");
  EXPECT_EQ(bytes_of(path), "new");
}

TEST_F(WholeFile, HasThePermissionsOfAnOrdinaryNewFile) {
  write_whole(in_folder("a"), "x");
  file("b", "x");
  struct stat ours, ordinary;
  ASSERT_EQ(::stat(in_folder("a").c_str(), &ours), 0);
  ASSERT_EQ(::stat(in_folder("b").c_str(), &ordinary), 0);
  EXPECT_EQ(ours.st_mode, ordinary.st_mode);
}

TEST_F(WholeFile, KeepsThePermissionsOfTheOneItReplaces) {
  using std::filesystem::perms;
  for (const auto mode : {perms::owner_read | perms::owner_write, perms::all, perms::owner_read}) {
    const auto path = file("a.txt", "old");
    std::filesystem::permissions(path, mode);
    write_whole(path, "new");
    EXPECT_EQ(std::filesystem::status(path).permissions(), mode);
    EXPECT_EQ(bytes_of(path), "new");
    std::filesystem::remove(path);
  }
}

/// One that has a name before it is whole, on a file system that can do no better.
TEST_F(WholeFile, LeavesNothingHalfWrittenWhateverEndsTheProgram) {
  files_without_names = false;
  const auto path = in_folder("a.txt");
  write_whole(path, "old");
  for (const int signal : {SIGTERM, SIGKILL}) {
    const auto child = ::fork();
    if (child == 0) write_whole(path, [&](const auto&) { std::raise(signal); });
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal);
    for (int tries = 0; tries < 1000 && files_in_folder() > 1; ++tries)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(files_in_folder(), 1) << "beside the old one, which stays";
  }
  EXPECT_EQ(bytes_of(path), "old");
  files_without_names = true;
}

TEST_F(WholeFile, FollowsASymbolicLink) {
  const auto target = file("target", "old");
  std::filesystem::create_symlink(target, in_folder("link"));
  write_whole(in_folder("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(in_folder("link")));
  EXPECT_EQ(bytes_of(target), "new");
}

TEST_F(WholeFile, FollowsALinkToWhatIsNotThereYet) {
  namespace fs = std::filesystem;
  fs::create_directory(in_folder("there"));
  fs::create_symlink("there/a", in_folder("link"));
  fs::create_symlink("link", in_folder("way"));
  write_whole(in_folder("way"), "new");
  for (const char* link : {"link", "way"}) EXPECT_TRUE(fs::is_symlink(in_folder(link)));
  EXPECT_EQ(bytes_of(in_folder("there/a")), "new");
  fs::create_symlink("nowhere/a", in_folder("lost"));
  EXPECT_ERROR(write_whole(in_folder("lost"), "new"), "nowhere/a: cannot be written: No such file");
  EXPECT_ERROR(require_place_for(in_folder("lost")), "nowhere: no such directory");
  EXPECT_NO_THROW(require_place_for(in_folder("way")));
  fs::create_symlink("round", in_folder("round"));
  EXPECT_ERROR(write_whole(in_folder("round"), "new"), "round: cannot be written: Too many");
}

TEST_F(WholeFile, LeavesTheOldOneWhenTheFillingFails) {
  const auto path = file("a.txt", "old");
  const auto fail = [](const coppermoon::files::Handle& made) {
    ASSERT_FALSE(write_at(made, 0, "half"));
    throw Error("stopped");
  };
  EXPECT_ERROR(write_whole(path, fail), "stopped");
  EXPECT_EQ(bytes_of(path), "old");
  EXPECT_EQ(files_in_folder(), 1) << "a temporary file stayed";
}

TEST_F(WholeFile, IsNotThereWhenTheDiskIsFull) {
  const auto path = in_folder("a.txt");
  {
    const SmallDisk disk(1000);
    EXPECT_ERROR(write_whole(path, std::string(5000, 'x')), "a.txt: cannot be written: File too");
  }
  EXPECT_EQ(files_in_folder(), 0);
}

TEST_F(WholeFile, NeedsItsFolder) {
  EXPECT_ERROR(write_whole(in_folder("no/a.txt"), "x"),
               "no/a.txt: cannot be written: No such file or directory");
}

TEST_F(WholeFile, IsNoDirectory) {
  EXPECT_ERROR(write_whole(in_folder(""), "x"), "Is a directory");
  std::filesystem::create_directory(in_folder("d"));
  EXPECT_ERROR(write_whole(in_folder("d"), "x"), "d: cannot be written: Is a directory");
}

TEST_F(WholeFile, IsNoDevice) {
  EXPECT_ERROR(write_whole("/dev/full", "x"), "/dev/full: cannot be written: not a regular file");
}

TEST_F(WholeFile, NeedsPermission) {
  using std::filesystem::perms;
  const auto everyone_reads = perms::owner_read | perms::owner_exec | perms::group_read |
                              perms::group_exec | perms::others_read | perms::others_exec;
  std::filesystem::permissions(in_folder(""), everyone_reads);
  const auto self = ::geteuid();
  constexpr uid_t nobody = 65534;  // the superuser may write anywhere
  if (self == 0) {
    ASSERT_EQ(::seteuid(nobody), 0);
  }
  EXPECT_ERROR(write_whole(in_folder("a"), "x"), "Permission denied");
  ASSERT_EQ(::seteuid(self), 0);
  std::filesystem::permissions(in_folder(""), perms::owner_all);
}

TEST(NamesOnWindows, AreNoDevicesAndHaveNoSignsOfItsOwn) {
  for (const auto* name :
       {"moon.exr", "Ö 月.exr", ".hidden", "..", "console.exr", "com.exr", "com10", "a b"})
    EXPECT_EQ(coppermoon::files::why_not_on_windows(name), "") << name;
  for (const auto* name : {"CON", "con.exr", "nul", "Aux .txt", "COM1", "lpt9.png"})
    EXPECT_EQ(coppermoon::files::why_not_on_windows(name), "is a device") << name;
  for (const auto* name : {"moon.", "moon ", "..."})
    EXPECT_EQ(coppermoon::files::why_not_on_windows(name), "ends in a dot or a blank") << name;
  for (const auto* name : {"a:b", "a?", "<a>", "a|b", "a*", "a\nb", "\"a\""})
    EXPECT_EQ(coppermoon::files::why_not_on_windows(name), "has one of <>:\"|?*") << name;
}

}  // namespace whole_file_test
