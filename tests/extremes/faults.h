// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <thread>

#include "algebra/random.h"
#include "support/program.h"
#include "support/thorough.h"

namespace coppermoon::extremes {

namespace fs = std::filesystem;

/// How many random moments a test tries.
inline int moments(int all) { return support::thorough() ? all : 3; }

/// Runs that something happens to.
class Faults : public ProgramTest {
 protected:
  void done(const Words& words) const { expect_done(coppermoon(words)); }

  /// Seconds that a run takes.
  double seconds_of(const Words& words) const {
    const auto start = std::chrono::steady_clock::now();
    done(words);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  auto files() const { return contents(here()); }

  /// Whether any process stands in the test's folders.
  bool any_at_work() const {
    const auto home = here().parent_path().parent_path().string();
    for (const auto& entry : fs::directory_iterator("/proc")) {
      std::error_code none;
      const auto folder = fs::read_symlink(entry.path() / "cwd", none).string();
      if (!none && folder.starts_with(home)) return true;
    }
    return false;
  }

  /// What stands in the temporary folder; also what goes while it is read.
  std::set<std::string> temporaries() const {
    std::set<std::string> names;
    try {
      for (const auto& name : listing())
        if (name.starts_with("tmp")) names.insert(name);
    } catch (const fs::filesystem_error& gone) {
      names.insert(gone.what());
    }
    return names;
  }

  /// What is left in the temporary folder once all have gone, for ten seconds at most.
  std::set<std::string> left_behind() const {
    std::set<std::string> left;
    for (int tenths = 0; tenths < 100; ++tenths) {
      left = temporaries();
      if (left.empty() && !any_at_work()) return left;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    if (any_at_work()) left.insert("a process");
    return left;
  }

  /// Kills a run at random moments of its time; each time nothing partial may be left, and the next run
  /// has to complete.
  ///
  /// Given  fresh  makes the folder ready again
  void expect_whole_wherever_killed(const Words& words, int times,
                                    const std::function<void()>& fresh) {
    const auto before = files();
    const double lasts_s = seconds_of(words);
    const auto whole = files();
    algebra::Random random(20080221, 0);
    for (int i = 0; i < times; ++i) {
      fresh();
      const double moment_s = lasts_s * 1.1 * random.uniform();
      const auto killed = coppermoon(words, {.killed_after_s = moment_s});
      EXPECT_EQ(left_behind(), std::set<std::string>{}) << "killed after " << moment_s << " s";
      for (const auto& [name, bytes] : files()) {
        const bool old = before.contains(name) && before.at(name) == bytes;
        EXPECT_TRUE(old || (whole.contains(name) && whole.at(name) == bytes))
            << name << ", killed after " << moment_s << " s";
      }
      expect_all_there(killed.out);
      done(words);
      EXPECT_TRUE(files() == whole) << "the run after the one killed after " << moment_s << " s";
    }
  }

  /// Waits for a file to appear, for a minute at most.
  bool appears(const fs::path& path) const {
    for (int tenths = 0; tenths < 600 && !fs::exists(path); ++tenths)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return fs::exists(path);
  }

  /// What a run told of before it was killed; a film, each frame by its number.
  virtual void expect_all_there(const std::string&) const {}

  /// A program of the folder that goes before the system's.
  Surroundings with_povray(const std::string& script) const {
    fs::create_directory(here("bin"));
    ProgramFolder::script("bin/povray", script);
    return {.path = here("bin").string() + ":" + ::getenv("PATH")};
  }

  void expect_one_line(const Outcome& outcome, const std::string& what) const {
    EXPECT_EQ(outcome.status, 1) << what << ": " << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("coppermoon: ")) << what << ": " << outcome.err;
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << what << ": " << outcome.err;
  }
};

}  // namespace coppermoon::extremes
