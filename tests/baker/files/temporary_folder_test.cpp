// SPDX-License-Identifier: MIT
#include "files/temporary_folder.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#include <chrono>
#include <thread>

#include "support/testing.h"

namespace coppermoon::files::temporary_folder_test {

bool gone_within_10_s(const std::filesystem::path& path) {
  for (int tries = 0; tries < 1000 && std::filesystem::exists(path); ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return !std::filesystem::exists(path);
}

TEST(TemporaryFolder, GoesWithItsOwner) {
  std::filesystem::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    EXPECT_TRUE(std::filesystem::is_directory(path));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(TemporaryFolder, GoesWithAProgramThatIsKilledAndAllOfItsGroup) {
  Pipe name;
  const pid_t program = ::fork();
  if (program == 0) {
    ::setpgid(0, 0);
    const TemporaryFolder folder;
    const std::string path = folder.path();
    if (::write(static_cast<int>(name.in.number), path.data(), path.size()) > 0) ::pause();
    ::_exit(1);
  }
  const std::filesystem::path path = read_some(name.out);
  EXPECT_TRUE(std::filesystem::is_directory(path));
  ::kill(-program, SIGKILL);
  ::waitpid(program, nullptr, 0);
  EXPECT_TRUE(gone_within_10_s(path)) << path;
}

TEST(RemovalAtEnd, LeavesWhatOutlivesIt) {
  const TemporaryFolder folder;
  { const RemovalAtEnd removal(folder.path() / "."); }
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_TRUE(std::filesystem::exists(folder.path()));
}

}  // namespace coppermoon::files::temporary_folder_test
