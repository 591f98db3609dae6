// SPDX-License-Identifier: MIT
#include "povray_scenes/process.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "algebra/error.h"
#include "files/child_process.h"
#include "povray_scenes/scene.h"

namespace coppermoon::povray_scenes {
namespace {

namespace fs = std::filesystem;
using algebra::Error;
using Clock = std::chrono::steady_clock;

/// Parser of POV-Ray's messages: counts of frames and pixels, and errors.
struct Conversation {
  const Run& run;
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
      if (run.progress && done < all)
        run.progress(static_cast<double>(done) / static_cast<double>(all));
    } else if (std::sscanf(line.c_str(), "Rendering frame %lu of %lu", &done, &all) == 2) {
      if (run.begun) run.begun(done);
    } else if (!line.empty()) {
      heed();
      last_line = line;
    }
    line.clear();
  }
  /// Collects lines from the first error on; POV-Ray folds long lines before a space.
  void heed() {
    const bool begun = !complaint.empty();
    if (!begun && line.find("rror") == std::string::npos) return;
    if (complaint.size() > 1000) return;
    complaint += (begun && line.front() != ' ' ? "; " : "") + line;
  }
  const std::string& last_words() const { return complaint.empty() ? last_line : complaint; }
};

/// Arguments for a window. An edge at 0 is left out, since POV-Ray takes numbers up to 1 for shares of the picture.
std::vector<std::string> words_for(const RenderWindow& window) {
  algebra::require_within("width of the window [pixels]",
                          static_cast<double>(window.right) - static_cast<double>(window.left), 2,
                          65535);
  algebra::require_within("height of the window [pixels]",
                          static_cast<double>(window.bottom) - static_cast<double>(window.top), 2,
                          65535);
  std::vector<std::string> words{fmt::format("+EC{}", window.right),
                                 fmt::format("+ER{}", window.bottom)};
  if (window.left > 0) words.push_back(fmt::format("+SC{}", window.left + 1));
  if (window.top > 0) words.push_back(fmt::format("+SR{}", window.top + 1));
  return words;
}

std::vector<std::string> command(const RenderSettings& settings, const Run& run) {
  std::vector<std::string> words{settings.povray, settings_file, "+O" + run.output, "-D", "-P"};
  words.push_back(run.progress ? "+V" : "-V");
  words.insert(words.end(), run.subset.begin(), run.subset.end());
  if (settings.window) {
    const auto part = words_for(*settings.window);
    words.insert(words.end(), part.begin(), part.end());
  }
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

/// Watch for the closing of a written file; never reports where the system has no more watches.
class Closing {
 public:
  Closing(const fs::path& folder, std::string file) : file_(std::move(file)) {
    watch_.number = ::inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    if (watch_.number >= 0 &&
        ::inotify_add_watch(watch_.number, folder.c_str(), IN_CLOSE_WRITE) < 0)
      watch_.close();
  }

  /// Readable when some file was closed; below 0: there is no watch.
  int descriptor() const { return watch_.number; }

  bool closed() const {
    alignas(inotify_event) std::array<char, 4096> events;
    const auto count = ::read(watch_.number, events.data(), events.size());
    for (std::ptrdiff_t at = 0; at < count;) {
      const auto* event = reinterpret_cast<const inotify_event*>(events.data() + at);
      if (event->len > 0 && file_ == event->name) return true;
      at += static_cast<std::ptrdiff_t>(sizeof *event + event->len);
    }
    return false;
  }

 private:
  std::string file_;
  files::FileDescriptor watch_;
};

/// Reads POV-Ray's messages until it ends, or closes its file.
///
/// Returned  whether it closed its file and may still run
bool listen(Conversation& heard, int from, const Closing* closing, const RenderSettings& settings) {
  const auto start = Clock::now();
  std::array<char, 4096> buffer;
  for (;;) {
    std::array<pollfd, 2> waiting{
        {{from, POLLIN, 0}, {closing ? closing->descriptor() : -1, POLLIN, 0}}};
    if (::poll(waiting.data(), waiting.size(), milliseconds_left(settings, start)) <= 0) continue;
    if (waiting[1].revents != 0 && closing->closed()) return true;
    if (waiting[0].revents == 0) continue;
    const auto count = ::read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    heard.hear({buffer.data(), static_cast<std::size_t>(count)});
  }
  heard.end_line();
  return false;
}

}  // namespace

Draft::Draft(const fs::path& in)
    : folder(in), stem(fmt::format("frame.tmp.{:08x}", std::random_device{}())) {
  std::error_code failure;
  if (!fs::is_regular_file(folder / settings_file, failure))
    throw Error(fmt::format("{}: not found", (folder / settings_file).string()));
}

Draft::~Draft() {
  std::error_code ignored;
  std::vector<fs::path> left;
  for (fs::directory_iterator file(folder, ignored), end; file != end; file.increment(ignored))
    if (file->path().filename().string().starts_with(stem)) left.push_back(file->path());
  for (const auto& file : left) fs::remove(file, ignored);
}

fs::path Draft::finish(const std::string& ending, const std::string& name,
                       const std::string& povray) const {
  std::error_code failure;
  fs::rename(folder / (stem + ending), folder / name, failure);
  if (failure)
    throw Error(
        fmt::format("{}: wrote no {}: {}", povray, (folder / name).string(), failure.message()));
  return folder / name;
}

void run_povray(const RenderSettings& settings, const Draft& draft, const Run& run) {
  algebra::require_within("threads", settings.threads, 0, 512);
  algebra::require_within("timeout [s]", settings.timeout_s, 0, 1e7);
  files::Pipe words;
  files::Child child;
  std::optional<Closing> closing;
  if (run.until_closed) closing.emplace(draft.folder, run.output);
  std::vector<std::string> environment;
  if (!run.with_users_settings)  // ours stand in their place
    environment.push_back(std::string("POVINI=") + settings_file);
  files::start(child, {command(settings, run), "povray", draft.folder, environment},
               {.error = words.in.number});
  words.in.close();
  Conversation heard{run};
  if (listen(heard, words.out.number, closing ? &*closing : nullptr, settings)) return;
  const int status = child.status();
  if (WIFSIGNALED(status))
    throw Error(fmt::format("{}: ended by signal {}", settings.povray, WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0)
    throw Error(fmt::format("{}: {}", settings.povray, heard.last_words()));
}

}  // namespace coppermoon::povray_scenes
