// SPDX-License-Identifier: MIT
#include "povray_scenes/render.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <random>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "povray_scenes/scene.h"

namespace coppermoon::povray_scenes {
namespace {

namespace fs = std::filesystem;
using algebra::Error;
using Clock = std::chrono::steady_clock;

/// The frame under way: its name tells of no other, and nothing of it is left behind.
struct Draft {
  fs::path folder;
  std::string stem = fmt::format("frame.tmp.{:08x}", std::random_device{}());

  explicit Draft(fs::path in) : folder(std::move(in)) {}
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft() {
    std::error_code ignored;
    fs::remove(folder / (stem + ".exr"), ignored);
    fs::remove(folder / (stem + ".pov-state"), ignored);
  }
};

struct FileDescriptor {
  int number = -1;

  FileDescriptor() = default;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor() { close(); }
  void close() {
    if (number >= 0) ::close(number);
    number = -1;
  }
};

/// A running program; killed when it is left before its end.
struct Child {
  pid_t id = 0;

  Child() = default;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (id <= 0) return;
    ::kill(id, SIGKILL);
    status();
  }
  int status() {
    int result = 0;
    while (::waitpid(id, &result, 0) < 0 && errno == EINTR) continue;
    id = 0;
    return result;
  }
};

/// What POV-Ray says: its count of pixels, and what it complains of.
struct Conversation {
  algebra::Progress progress;
  std::string line{}, last_line{}, complaint{};

  void hear(std::string_view chunk) {
    for (const char c : chunk)
      if (c == '\n' || c == '\r')
        end_line();
      else
        line += c;
  }
  void end_line() {
    unsigned long done = 0, all = 0;
    if (std::sscanf(line.c_str(), "Rendered %lu of %lu pixels", &done, &all) == 2) {
      if (progress && done < all) progress(static_cast<double>(done) / static_cast<double>(all));
    } else if (!line.empty()) {
      heed();
      last_line = line;
    }
    line.clear();
  }
  /// From the first line that speaks of an error on; POV-Ray folds long lines before a space.
  void heed() {
    const bool begun = !complaint.empty();
    if (!begun && line.find("rror") == std::string::npos) return;
    if (complaint.size() > 1000) return;
    complaint += (begun && line.front() != ' ' ? "; " : "") + line;
  }
  const std::string& last_words() const { return complaint.empty() ? last_line : complaint; }
};

class SpawnActions {
 public:
  SpawnActions(const fs::path& folder, int standard_error) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, standard_error, STDERR_FILENO);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions_); }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

void spawn(Child& child, std::vector<std::string> arguments, const fs::path& folder,
           int standard_error) {
  std::vector<char*> pointers;
  for (auto& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const SpawnActions actions(folder, standard_error);
  const int failure =
      posix_spawnp(&child.id, pointers[0], actions.get(), nullptr, pointers.data(), environ);
  if (failure == 0) return;
  child.id = 0;
  if (failure == ENOENT)
    throw Error(fmt::format("{}: not found; install the package povray", arguments[0]));
  throw Error(fmt::format("{}: cannot be run: {}", arguments[0], std::strerror(failure)));
}

std::vector<std::string> command(const RenderSettings& settings, const Draft& draft) {
  std::vector<std::string> words{
      settings.povray, settings_file, "+O" + draft.stem + ".exr", "-D", "-P", "+V"};
  if (settings.threads > 0) words.push_back(fmt::format("+WT{}", settings.threads));
  return words;
}

int milliseconds_left(const RenderSettings& settings, Clock::time_point start) {
  if (settings.timeout_s == 0) return -1;
  const double used_s = std::chrono::duration<double>(Clock::now() - start).count();
  if (used_s >= settings.timeout_s)
    throw Error(fmt::format("{}: not done after {:g} s, the time allowed", settings.povray,
                            settings.timeout_s));
  return static_cast<int>(std::min(settings.timeout_s - used_s, 1e3) * 1e3) + 1;
}

void listen(Conversation& heard, int from, const RenderSettings& settings) {
  const auto start = Clock::now();
  std::array<char, 4096> buffer;
  for (;;) {
    pollfd waiting{from, POLLIN, 0};
    if (::poll(&waiting, 1, milliseconds_left(settings, start)) <= 0) continue;
    const auto count = ::read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    heard.hear({buffer.data(), static_cast<std::size_t>(count)});
  }
  heard.end_line();
}

/// Runs to the end, or throws.
void run(const RenderSettings& settings, const Draft& draft, const algebra::Progress& progress) {
  FileDescriptor ours, theirs;
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw Error(fmt::format("povray: cannot be listened to: {}", std::strerror(errno)));
  ours.number = ends[0], theirs.number = ends[1];
  Child child;
  spawn(child, command(settings, draft), draft.folder, theirs.number);
  theirs.close();
  Conversation heard{progress};
  listen(heard, ours.number, settings);
  const int status = child.status();
  if (WIFSIGNALED(status))
    throw Error(fmt::format("{}: ended by signal {}", settings.povray, WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0)
    throw Error(fmt::format("{}: {}", settings.povray, heard.last_words()));
}

}  // namespace

std::filesystem::path render(const std::filesystem::path& folder, const RenderSettings& settings,
                             const algebra::Progress& progress) {
  algebra::require_within("threads", settings.threads, 0, 512);
  algebra::require_within("timeout [s]", settings.timeout_s, 0, 1e7);
  std::error_code failure;
  if (!fs::is_regular_file(folder / settings_file, failure))
    throw Error(fmt::format("{}: not found", (folder / settings_file).string()));
  const Draft draft(folder);
  run(settings, draft, progress);
  const fs::path frame = folder / frame_file;
  fs::rename(folder / (draft.stem + ".exr"), frame, failure);
  if (failure)
    throw Error(
        fmt::format("{}: wrote no {}: {}", settings.povray, frame.string(), failure.message()));
  if (progress) progress(1);
  return frame;
}

}  // namespace coppermoon::povray_scenes
