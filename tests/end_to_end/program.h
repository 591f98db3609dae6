// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace coppermoon::end_to_end {

using Words = std::vector<std::string>;

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// How a program ended and what it said.
struct Outcome {
  int status = -1;  ///< of its exit; 128 + the signal's number when it was ended by one
  std::string out, err;
  double most_memory_mb = 0;  ///< that it, or a program of its own, had at one time
};

/// What a program finds around it.
struct Surroundings {
  std::optional<std::string> path = {};     ///< PATH, instead of ours
  std::optional<rlim_t> file_limit = {};    ///< bytes that a file may have: the disk is full there
  std::optional<rlim_t> memory_limit = {};  ///< bytes of addresses that it may have
  std::optional<rlim_t> processor_limit = {};  ///< seconds of all its threads, then SIGXCPU ends it
  std::optional<double> killed_after_s = {};   ///< by kill -9, unless it has ended
  std::optional<std::filesystem::path> preloaded = {};  ///< a library that goes before all others
  std::optional<std::filesystem::path> folder = {};  ///< where it runs, instead of the test's own
};

/// What a program said, without the lines that it is at work: how many there are, the machine's load decides.
inline std::string without_waiting(std::string said) {
  const std::string words = ": at work for ";
  for (auto at = said.find(words); at != said.npos; at = said.find(words)) {
    const auto begin = said.rfind('\n', at) + 1;
    said.erase(begin, said.find('\n', at) + 1 - begin);
  }
  return said;
}

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A folder of its own, gone afterwards; programs run in it, with their own temporary folder beside it.
class ProgramFolder {
 public:
  ProgramFolder() {
    auto name = (std::filesystem::temp_directory_path() / "coppermoon test XXXXXX").string();
    home_ = ::mkdtemp(name.data());
    for (const char* part : {"here", "tmp", "said"})
      std::filesystem::create_directory(home_ / part);
  }
  ~ProgramFolder() { std::filesystem::remove_all(home_); }
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

  std::filesystem::path here(std::string_view name = {}) const { return home_ / "here" / name; }

  std::filesystem::path file(std::string_view name, std::string_view bytes) const {
    std::ofstream(here(name), std::ios::binary) << bytes;
    return here(name);
  }

  /// All that stands in the folder and in the programs' temporary one.
  std::set<std::string> listing() const {
    std::set<std::string> names;
    for (const char* part : {"here", "tmp"})
      for (const auto& entry : std::filesystem::recursive_directory_iterator(home_ / part))
        names.insert(entry.path().lexically_relative(home_).string());
    return names;
  }

  Outcome run(std::vector<std::string> words, const Surroundings& around = {}) const {
    return ended(begun(std::move(words), around), around);
  }

  /// One that goes on in the background: see ended.
  pid_t begun(std::vector<std::string> words, const Surroundings& around = {}) const {
    const pid_t child = ::fork();
    if (child == 0) become(words, around);
    return child;
  }

  Outcome ended(pid_t child, const Surroundings& around = {}) const {
    if (around.killed_after_s) {
      ::usleep(static_cast<useconds_t>(*around.killed_after_s * 1e6));
      ::kill(child, SIGKILL);
    }
    int status = 0;
    rusage used{};
    ::wait4(child, &status, 0, &used);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
            text_of(home_ / "said/out"), without_waiting(text_of(home_ / "said/err")),
            static_cast<double>(used.ru_maxrss) * 1024e-6};
  }

  Outcome coppermoon(std::vector<std::string> words, const Surroundings& around = {}) const {
    words.insert(words.begin(), COPPERMOON_PROGRAM);
    return run(std::move(words), around);
  }

 private:
  void say_into(const char* name, int descriptor) const {
    const auto file = home_ / "said" / name;
    ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), descriptor);
  }

  [[noreturn]] void become(std::vector<std::string>& words, const Surroundings& around) const {
    say_into("out", STDOUT_FILENO);
    say_into("err", STDERR_FILENO);
    ::setenv("TMPDIR", (home_ / "tmp").c_str(), 1);
    if (around.path) ::setenv("PATH", around.path->c_str(), 1);
    if (::chdir(around.folder.value_or(here()).c_str()) != 0) ::_exit(126);
    const rlimit limit{around.file_limit.value_or(RLIM_INFINITY), RLIM_INFINITY};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    if (around.memory_limit) {
      const rlimit memory{*around.memory_limit, RLIM_INFINITY};
      ::setrlimit(RLIMIT_AS, &memory);
    }
    if (around.processor_limit) {
      const rlimit processor{*around.processor_limit, RLIM_INFINITY};
      ::setrlimit(RLIMIT_CPU, &processor);
    }
    if (around.preloaded) ::setenv("LD_PRELOAD", around.preloaded->c_str(), 1);
    std::vector<char*> pointers;
    for (auto& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    ::execvp(pointers[0], pointers.data());
    ::_exit(127);
  }

  std::filesystem::path home_;
};

/// A folder for each test.
class ProgramTest : public testing::Test, protected ProgramFolder {};

/// Standard error without the note on options of a Moon in shadow that stand beside --unshadowed: tests light one Moon
/// with the Earth and without by the same options.
inline std::string complaint_of(const Outcome& outcome) {
  std::istringstream lines(outcome.err);
  std::string rest;
  for (std::string line; std::getline(lines, line);)
    if (!line.ends_with(": no effect beside --unshadowed")) rest += line + '\n';
  return rest;
}

/// Done, with nothing on stderr.
inline void expect_done(const Outcome& outcome) {
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(complaint_of(outcome), "");
}

}  // namespace coppermoon::end_to_end
