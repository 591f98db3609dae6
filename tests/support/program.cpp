// SPDX-License-Identifier: MIT
#include "support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <iomanip>

template class nlohmann::basic_json<>;

namespace coppermoon {
namespace {

/// What a program said, without the lines that it is at work: how many there are, the machine's load decides.
std::string without_waiting(std::string said) {
  const std::string words = ": at work for ";
  for (auto at = said.find(words); at != said.npos; at = said.find(words)) {
    const auto begin = said.rfind('\n', at) + 1;
    said.erase(begin, said.find('\n', at) + 1 - begin);
  }
  return said;
}

void say_into(const std::filesystem::path& file, int descriptor) {
  ::dup2(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666), descriptor);
}

}  // namespace

Words::Words(const char* line) {
  std::istringstream text(line);
  for (std::string word; text >> std::quoted(word, '\'');) push_back(word);
}

Words& operator+=(Words& words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Words operator+(Words words, const Words& more) { return words += more; }

Words words_of_texts(const char* line, const std::vector<std::string>& parts) {
  Words all(line);
  auto word = all.begin();
  for (const auto& part : parts) {
    while (word->find("{}") == word->npos) ++word;
    word->replace(word->find("{}"), 2, part);
    if (word->find("{}") == word->npos) ++word;
  }
  return all;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::map<std::string, std::string> contents(const std::filesystem::path& folder) {
  std::map<std::string, std::string> all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      all[entry.path().lexically_relative(folder).string()] = text_of(entry.path());
  return all;
}

ProgramFolder::ProgramFolder() {
  auto name = (std::filesystem::temp_directory_path() / "coppermoon test XXXXXX").string();
  home_ = ::mkdtemp(name.data());
  for (const char* part : {"here", "tmp", "said"}) std::filesystem::create_directory(home_ / part);
}

ProgramFolder::~ProgramFolder() { std::filesystem::remove_all(home_); }

std::filesystem::path ProgramFolder::here(std::string_view name) const {
  return home_ / "here" / name;
}

std::filesystem::path ProgramFolder::file(std::string_view name, std::string_view bytes) const {
  std::ofstream(here(name), std::ios::binary) << bytes;
  return here(name);
}

std::filesystem::path ProgramFolder::script(std::string_view name, std::string_view text) const {
  const auto path = file(name, "#!/bin/sh\n" + std::string(text) + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

std::set<std::string> ProgramFolder::listing() const {
  std::set<std::string> names;
  for (const char* part : {"here", "tmp"})
    for (const auto& entry : std::filesystem::recursive_directory_iterator(home_ / part))
      names.insert(entry.path().lexically_relative(home_).string());
  return names;
}

Outcome ProgramFolder::run(Words words, const Surroundings& around) const {
  return ended(begun(std::move(words), around), around);
}

pid_t ProgramFolder::begun(Words words, const Surroundings& around) const {
  const pid_t child = ::fork();
  if (child == 0) become(words, around);
  return child;
}

Outcome ProgramFolder::ended(pid_t child, const Surroundings& around) const {
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

Outcome ProgramFolder::coppermoon(Words words, const Surroundings& around) const {
  words.insert(words.begin(), COPPERMOON_PROGRAM);
  return run(std::move(words), around);
}

void ProgramFolder::become(Words& words, const Surroundings& around) const {
  say_into(home_ / "said/out", STDOUT_FILENO);
  say_into(home_ / "said/err", STDERR_FILENO);
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

std::string complaint_of(const Outcome& outcome) {
  std::istringstream lines(outcome.err);
  std::string rest;
  for (std::string line; std::getline(lines, line);)
    if (!line.ends_with(": no effect beside --unshadowed")) rest += line + '\n';
  return rest;
}

void expect_done(const Outcome& outcome) {
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(complaint_of(outcome), "");
}

nlohmann::json ProgramTest::json_of(const Words& words) const {
  const auto outcome = coppermoon(words + "--json");
  expect_done(outcome);
  return nlohmann::json::parse(outcome.out, nullptr, false);
}

std::string ProgramTest::expect_refused(const Words& words,
                                        std::initializer_list<std::string_view> parts, int status,
                                        const Surroundings& around) const {
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

std::string ProgramTest::expect_refused(const Words& words, std::string_view part, int status,
                                        const Surroundings& around) const {
  return expect_refused(words, {part}, status, around);
}

void ProgramTest::expect_refusal(const Words& words, const std::string& why, int status,
                                 const Surroundings& around) const {
  EXPECT_EQ(expect_refused(words, why, status, around), "coppermoon: " + why + "\n");
}

}  // namespace coppermoon
