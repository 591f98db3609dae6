// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/types.h>

#include <nlohmann/json.hpp>

#include "support/testing.h"

// compiled once, in program.cpp
extern template class nlohmann::basic_json<>;

namespace coppermoon {

/// Words of a command line. One text is parted at its blanks, as a shell does; '…' holds a word together.
struct Words : std::vector<std::string> {
  Words() = default;
  Words(std::initializer_list<std::string> words) : vector(words) {}
  Words(const_iterator first, const_iterator last) : vector(first, last) {}
  Words(const char* line);
};

Words& operator+=(Words& words, const Words& more);
Words operator+(Words words, const Words& more);

/// Words of a line whose {} stand for the parts: a part is never parted.
Words words_of_texts(const char* line, const std::vector<std::string>& parts);

template <class... Parts>
Words words_of(const char* line, const Parts&... parts) {
  const auto text = [](const auto& part) -> std::string {
    if constexpr (std::is_convertible_v<decltype(part), std::string>)
      return part;
    else
      return fmt::format("{}", part);
  };
  return words_of_texts(line, {text(parts)...});
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

/// Bytes of a file.
std::string text_of(const std::filesystem::path& file);

/// Every file in a folder, by its name there, and its bytes.
std::map<std::string, std::string> contents(const std::filesystem::path& folder);

/// A folder of its own, gone afterwards; programs run in it, with their own temporary folder beside it.
class ProgramFolder {
 public:
  ProgramFolder();
  ~ProgramFolder();
  ProgramFolder(const ProgramFolder&) = delete;
  ProgramFolder& operator=(const ProgramFolder&) = delete;

  std::filesystem::path here(std::string_view name = {}) const;
  std::filesystem::path file(std::string_view name, std::string_view bytes) const;
  /// A script of the shell, in the folder, that can be run.
  std::filesystem::path script(std::string_view name, std::string_view text) const;
  /// All that stands in the folder and in the programs' temporary one.
  std::set<std::string> listing() const;

  Outcome run(Words words, const Surroundings& around = {}) const;
  /// One that goes on in the background: see ended.
  pid_t begun(Words words, const Surroundings& around = {}) const;
  Outcome ended(pid_t child, const Surroundings& around = {}) const;
  Outcome coppermoon(Words words, const Surroundings& around = {}) const;

 private:
  [[noreturn]] void become(Words& words, const Surroundings& around) const;

  std::filesystem::path home_;
};

/// Standard error without the note on options of a Moon in shadow that stand beside --unshadowed: tests light one Moon
/// with the Earth and without by the same options.
std::string complaint_of(const Outcome& outcome);

/// Done, with nothing on stderr.
void expect_done(const Outcome& outcome);

/// A folder for each test.
class ProgramTest : public testing::Test, protected ProgramFolder {
 protected:
  /// What the program, asked for --json, prints.
  nlohmann::json json_of(const Words& words) const;

  /// Expects one line with the parts in it, nothing printed, and no file written, changed or lost.
  ///
  /// Returned  the line
  std::string expect_refused(const Words& words, std::initializer_list<std::string_view> parts,
                             int status = could_not, const Surroundings& around = {}) const;
  std::string expect_refused(const Words& words, std::string_view part, int status = could_not,
                             const Surroundings& around = {}) const;
  /// The same, of a line that is known whole.
  void expect_refusal(const Words& words, const std::string& why, int status = could_not,
                      const Surroundings& around = {}) const;
};

}  // namespace coppermoon
