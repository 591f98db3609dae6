// SPDX-License-Identifier: MIT
#include "files/temporary_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <string>
#include <system_error>

#include "algebra/error.h"

namespace coppermoon::files {
namespace {

/// Removes a file or a folder once nobody holds the other end of its standard input; signals to the program's
/// group do not reach it.
///
/// Returned  0 when there is no shell
pid_t remover_of(std::string path, int input) {
  std::string shell = "sh", command = "-c", script = "cat && rm -rf -- \"$0\"";
  std::array<char*, 5> words{shell.data(), command.data(), script.data(), path.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  for (const int said : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, said, "/dev/null", O_WRONLY, 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = 0;
  if (::posix_spawnp(&child, words[0], &actions, &attributes, words.data(), environ) != 0)
    child = 0;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return child;
}

}  // namespace

void require_temporary_folder() {
  std::error_code failed;
  if (!std::filesystem::temp_directory_path(failed).empty() && !failed) return;
  const char* told = std::getenv("TMPDIR");
  throw algebra::Error(fmt::format("TMPDIR = {}: no such directory, allowed one that is there",
                                   told != nullptr ? told : "/tmp"));
}

RemovalAtEnd::RemovalAtEnd(const std::filesystem::path& path) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return;
  alive_ = ends[1];
  remover_ = remover_of(std::filesystem::absolute(path).string(), ends[0]);
  ::close(ends[0]);
}

RemovalAtEnd::~RemovalAtEnd() {
  if (remover_ > 0) {
    ::kill(-remover_, SIGKILL);  // and all that it runs: it is the first of its own group
    ::waitpid(remover_, nullptr, 0);
  }
  if (alive_ >= 0) ::close(alive_);
}

TemporaryFolder::TemporaryFolder() {
  require_temporary_folder();
  std::string name = (std::filesystem::temp_directory_path() / "coppermoon-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw algebra::Error(
        fmt::format("{}: cannot be made: {}", name, std::generic_category().message(errno)));
  path_ = name;
  removal_.emplace(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace coppermoon::files
