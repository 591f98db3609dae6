// SPDX-License-Identifier: MIT
#include "povray_scenes/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <string_view>
#include <vector>

#include "algebra/error.h"
#include "files/child_process.h"
#include "povray_scenes/moon_scene.h"

namespace coppermoon::povray_scenes {
namespace {

namespace fs = std::filesystem;
using algebra::Error;

/// Parses POV-Ray's messages about frames, rendered pixels and errors.
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
  /// Collects POV-Ray's messages from the first error on. A line that begins with a space continues the previous line.
  void heed() {
    const bool begun = !complaint.empty();
    if (!begun && line.find("rror") == std::string::npos) return;
    if (complaint.size() > 1000) return;
    complaint += (begun && line.front() != ' ' ? "; " : "") + line;
  }
  const std::string& last_words() const { return complaint.empty() ? last_line : complaint; }
};

/// POV-Ray's arguments for part of the picture. Edges at 0 are left out, as POV-Ray reads numbers up to 1 as fractions.
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

/// POV-Ray's command line. On Windows, POV-Ray is a program with a window, and has to be told to render and to exit.
///
/// Source  help of POV-Ray 3.7 for Windows, "Special Command-Line Options"; not tested, as it does not run on Linux
std::vector<std::string> command(const RenderSettings& settings, const Run& run) {
  std::vector<std::string> words{
      files::program_file(settings.povray, {"pvengine64.exe", "POV-Ray/v3.7/bin"})};
  if (fs::path(words[0]).stem().string().starts_with("pvengine"))
    words.insert(words.end(), {"/EXIT", "/RENDER"});
  words.insert(words.end(), {settings_file, "+O" + run.output, "-D", "-P"});
  words.push_back(run.progress ? "+V" : "-V");
  words.insert(words.end(), run.subset.begin(), run.subset.end());
  if (settings.window) {
    const auto part = words_for(*settings.window);
    words.insert(words.end(), part.begin(), part.end());
  }
  if (settings.threads > 0) words.push_back(fmt::format("+WT{}", settings.threads));
  return words;
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
  std::vector<std::string> environment;
  if (!run.with_users_settings)  // read the scene's settings instead of the user's povray.ini
    environment.push_back(std::string("POVINI=") + settings_file);
  Conversation heard{run};
  const bool well = files::run_heard({command(settings, run), "povray", draft.folder, environment},
                                     {.hear = [&](std::string_view words) { heard.hear(words); },
                                      .until_closed = run.until_closed ? run.output : "",
                                      .timeout_s = settings.timeout_s});
  heard.end_line();
  if (!well) throw Error(fmt::format("{}: {}", settings.povray, heard.last_words()));
}

}  // namespace coppermoon::povray_scenes
