// SPDX-License-Identifier: MIT
#pragma once

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iomanip>
#include <nlohmann/json.hpp>

#include "support/testing.h"

namespace coppermoon {

/// Words of a command line. One text is parted at its blanks, as a shell does; '…' holds a word together.
struct Words : std::vector<std::string> {
  Words() = default;
  Words(std::initializer_list<std::string> words) : vector(words) {}
  Words(const_iterator first, const_iterator last) : vector(first, last) {}
  Words(const char* line) {
    std::istringstream text(line);
    for (std::string word; text >> std::quoted(word, '\'');) push_back(word);
  }
};

inline Words& operator+=(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

inline Words operator+(Words words, const Words& more) { return words += more; }

/// Words of a line whose {} stand for the parts: a part is never parted.
template <class... Parts>
Words words_of(const char* line, const Parts&... parts) {
  Words all(line);
  auto word = all.begin();
  const auto fill = [&](const std::string& part) {
    while (word->find("{}") == word->npos) ++word;
    word->replace(word->find("{}"), 2, part);
    if (word->find("{}") == word->npos) ++word;
  };
  const auto text = [](const auto& part) -> std::string {
    if constexpr (std::is_convertible_v<decltype(part), std::string>)
      return part;
    else
      return fmt::format("{}", part);
  };
  (fill(text(parts)), ...);
  return all;
}

constexpr int could_not = 1, wrong_usage = 2;  ///< statuses of the program

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
  unsigned seconds_limit = 0;                  ///< of the clock, then SIGALRM ends it; 0: none
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

/// Every file in a folder, by its name there, and its bytes.
inline std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      all[entry.path().lexically_relative(folder).string()] = text_of(entry.path());
  return all;
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

  /// A script of the shell, in the folder, that can be run.
  std::filesystem::path script(std::string_view name, std::string_view text) const {
    const auto path = file(name, "#!/bin/sh\n" + std::string(text) + "\n");
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

  /// All that stands in the folder and in the programs' temporary one.
  std::set<std::string> listing() const {
    std::set<std::string> names;
    for (const char* part : {"here", "tmp"})
      for (const auto& entry : std::filesystem::recursive_directory_iterator(home_ / part))
        names.insert(entry.path().lexically_relative(home_).string());
    return names;
  }

  Outcome run(Words words, const Surroundings& around = {}) const {
    return ended(begun(std::move(words), around), around);
  }

  /// One that goes on in the background: see ended.
  pid_t begun(Words words, const Surroundings& around = {}) const {
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

  Outcome coppermoon(Words words, const Surroundings& around = {}) const {
    words.insert(words.begin(), COPPERMOON_PROGRAM);
    return run(std::move(words), around);
  }

 private:
  void say_into(const char* name, int descriptor) const {
    const auto file = home_ / "said" / name;
    ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), descriptor);
  }

  [[noreturn]] void become(Words& words, const Surroundings& around) const {
    say_into("out", STDOUT_FILENO);
    say_into("err", STDERR_FILENO);
    ::setenv("TMPDIR", (home_ / "tmp").c_str(), 1);
    if (around.path) ::setenv("PATH", around.path->c_str(), 1);
    if (::chdir(around.folder.value_or(here()).c_str()) != 0) ::_exit(126);
    ::alarm(around.seconds_limit);
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

/// A folder for each test.
class ProgramTest : public testing::Test, protected ProgramFolder {
 protected:
  /// What the program, asked for --json, prints.
  nlohmann::json json_of(const Words& words) const {
    const auto outcome = coppermoon(words + "--json");
    expect_done(outcome);
    return nlohmann::json::parse(outcome.out, nullptr, false);
  }

  /// Expects one line with the parts in it, nothing printed, and no file written, changed or lost.
  ///
  /// Returned  the line
  std::string expect_refused(const Words& words, std::initializer_list<std::string_view> parts,
                             int status = could_not, const Surroundings& around = {}) const {
    const auto before = contents(here());
    const auto left = listing();
    const auto outcome = coppermoon(words, around);
    const auto said = complaint_of(outcome);
    EXPECT_EQ(outcome.status, status) << said;
    EXPECT_TRUE(said.starts_with("coppermoon: ")) << said;
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    for (const auto part : parts) EXPECT_SAYS(said, part);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(listing(), left);
    EXPECT_TRUE(contents(here()) == before);
    return said;
  }

  std::string expect_refused(const Words& words, std::string_view part, int status = could_not,
                             const Surroundings& around = {}) const {
    return expect_refused(words, {part}, status, around);
  }

  /// The same, of a line that is known whole.
  void expect_refusal(const Words& words, const std::string& why, int status = could_not,
                      const Surroundings& around = {}) const {
    EXPECT_EQ(expect_refused(words, why, status, around), "coppermoon: " + why + "\n");
  }
};

}  // namespace coppermoon
