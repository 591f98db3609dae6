// SPDX-License-Identifier: MIT
#include "files/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "algebra/error.h"
#include "files/file_end.h"

namespace coppermoon::files {
namespace {

using algebra::Error;

[[noreturn]] void refuse_pipe() {
  throw Error(fmt::format("no pipe to another program: {}", std::strerror(errno)));
}

/// Turns the forked child into the program; returns on failure. Calls only what is safe after a fork of many threads.
void become(char* const* arguments, char* const* variables, const Program& program,
            const Streams& streams, pid_t parent) {
  if (program.outlives_us ? ::setpgid(0, 0) != 0
                          : ::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != parent)
    return;
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing < 0 || ::chdir(program.folder.c_str()) != 0) return;
  const auto put = [&](int stream, int place) { ::dup2(stream < 0 ? nothing : stream, place); };
  put(streams.input, STDIN_FILENO), put(streams.output, STDOUT_FILENO),
      put(streams.error, STDERR_FILENO);
  ::execvpe(arguments[0], arguments, variables);
}

/// Environment of this process with some variables replaced.
std::vector<std::string> environment_with(std::vector<std::string> variables) {
  const auto named = variables;
  for (char** ours = environ; *ours != nullptr; ++ours) {
    const std::string_view variable = *ours;
    const auto name = variable.substr(0, variable.find('=') + 1);
    if (std::ranges::none_of(named, [&](const auto& other) { return other.starts_with(name); }))
      variables.emplace_back(variable);
  }
  return variables;
}

/// Null-terminated array for exec.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Value of errno that the child wrote before it ended, or 0 when exec closed the pipe.
int failure_of(int from) {
  int failure = 0;
  while (::read(from, &failure, sizeof failure) < 0 && errno == EINTR) continue;
  return failure;
}

/// Text read until the other end is closed; at most the first 4096 bytes.
std::string all_said(int from) {
  std::string said;
  std::array<char, 4096> buffer;
  for (;;) {
    const auto count = ::read(from, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return said;
    if (said.size() < buffer.size()) said.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

/// Last non-empty line of a text.
std::string last_line(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

/// First non-empty line of a text.
std::string first_line(std::string text) {
  text.erase(0, text.find_first_not_of('\n'));
  return text.substr(0, text.find('\n'));
}

/// Throws  Error  after a signal: its number; after another exit status than 0: `why`
void require_success(const Program& program, int status, const std::string& why) {
  if (WIFSIGNALED(status))
    throw Error(fmt::format("{}: ended by signal {}", program.words[0], WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) throw Error(why);
}

}  // namespace

void FileDescriptor::close() {
  if (number >= 0) ::close(number);
  number = -1;
}

Pipe::Pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) refuse_pipe();
  FileDescriptor low_out, low_in;
  low_out.number = ends[0], low_in.number = ends[1];
  out.number = ::fcntl(ends[0], F_DUPFD_CLOEXEC, 3);
  in.number = ::fcntl(ends[1], F_DUPFD_CLOEXEC, 3);
  if (out.number < 0 || in.number < 0) refuse_pipe();
}

Child::~Child() {
  if (id <= 0) return;
  ::kill(leads_group ? -id : id, SIGKILL);
  status();
}

int Child::status() {
  int result = 0;
  while (::waitpid(id, &result, 0) < 0 && errno == EINTR) continue;
  id = 0;
  return result;
}

/// Forks, since posix_spawn cannot ask for the child's end with ours.
void start(Child& child, const Program& program, const Streams& streams) {
  auto words = program.words, variables = environment_with(program.variables);
  const auto arguments = pointers_to(words), environment = pointers_to(variables);
  Pipe failed;
  const pid_t ourselves = ::getpid();
  child.leads_group = program.outlives_us;
  child.id = ::fork();
  if (child.id == 0) {
    become(arguments.data(), environment.data(), program, streams, ourselves);
    const int why = errno;
    [[maybe_unused]] const auto written = ::write(failed.in.number, &why, sizeof why);
    ::_exit(127);
  }
  const int not_forked = child.id < 0 ? errno : 0;
  failed.in.close();
  const int failure = not_forked ? not_forked : failure_of(failed.out.number);
  if (failure == 0) return;
  if (failure == ENOENT)
    throw Error(fmt::format("{}: not found; install the package {}", words[0], program.package));
  throw Error(fmt::format("{}: cannot be run: {}", words[0], std::strerror(failure)));
}

void run_program(const Program& program, std::optional<int> result) {
  Pipe words;
  Child child;
  start(child, program, {.output = result.value_or(-1), .error = words.in.number});
  words.in.close();
  const auto said = all_said(words.out.number);
  require_success(program, child.status(),
                  fmt::format("{}: {}", program.words[0], first_line(said)));
  if (result) require_whole(*result, program.words[0]);
}

void require_whole(int descriptor, const std::string& by) {
  struct stat made {};
  if (::fstat(descriptor, &made) != 0 || made.st_size == 0)
    throw Error(fmt::format("{}: ended without a result", by));
  if (!has_its_end(descriptor))
    throw Error(
        fmt::format("{}: its file is cut off after {} bytes; is the disk full?", by, made.st_size));
}

void require_whole(const std::filesystem::path& file, const std::string& by) {
  FileDescriptor made;
  made.number = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  require_whole(made.number, by);
}

std::string output_of(const Program& program) {
  Pipe words, output;
  Child child;
  start(child, program, {.output = output.in.number, .error = words.in.number});
  words.in.close(), output.in.close();
  const auto said = all_said(words.out.number);  // first: the output fits into a pipe
  auto made = all_said(output.out.number);
  require_success(program, child.status(), last_line(said));
  return made;
}

}  // namespace coppermoon::files
