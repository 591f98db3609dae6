// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>

#include "algebra/error.h"
#include "files/descriptor_posix.h"
#include "files/linux_or_macos.h"
#include "files/running_program.h"

namespace coppermoon::files {
namespace {

using algebra::Error;
using Clock = std::chrono::steady_clock;

[[noreturn]] void refuse_pipe() {
  throw Error(fmt::format("no pipe to another program: {}", std::strerror(errno)));
}

/// Replaces the forked child with the program; returns only on failure. It may call only functions that are safe after
/// a fork in a process with many threads.
void become(char* const* arguments, char* const* variables, const Program& program,
            const Streams& streams, pid_t parent) {
  if (program.outlives_us ? ::setpgid(0, 0) != 0 : !end_with(parent)) return;
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing < 0 || ::chdir(program.folder.c_str()) != 0) return;
  const auto put = [&](const Handle* stream, int place) {
    ::dup2(stream == nullptr ? nothing : descriptor_of(*stream), place);
  };
  put(streams.input, STDIN_FILENO), put(streams.output, STDOUT_FILENO),
      put(streams.error, STDERR_FILENO);
  execute(arguments, variables);
}

/// The environment of this process with the given variables added or replaced.
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

/// Pointers to the words, with a null pointer at the end, as exec expects them.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (auto& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Reads from a pipe why the child's exec failed (errno); 0 if exec succeeded, which closes the pipe without a value.
int failure_of(const Handle& from) {
  int failure = 0;
  while (::read(descriptor_of(from), &failure, sizeof failure) < 0 && errno == EINTR) continue;
  return failure;
}

/// Time left until a program's timeout [ms]; negative if there is no timeout.
///
/// Throws  Error  if no time is left
int milliseconds_left(const Program& program, double timeout_s, Clock::time_point start) {
  if (timeout_s == 0) return -1;
  const double used_s = std::chrono::duration<double>(Clock::now() - start).count();
  if (used_s >= timeout_s) throw not_done(program, timeout_s);
  return static_cast<int>(std::min(timeout_s - used_s, 1e3) * 1e3) + 1;
}

/// Passes on a program's messages until the program ends or closes the file `hearing.until_closed`.
///
/// Returned  true if the program closed the file and may still be running; false if it ended
bool listen(const Handle& words, const Handle& closing, const Program& program,
            const Hearing& hearing) {
  const auto start = Clock::now();
  for (;;) {
    std::array<pollfd, 2> waiting{
        {{descriptor_of(words), POLLIN, 0}, {descriptor_of(closing), POLLIN, 0}}};
    if (::poll(waiting.data(), waiting.size(),
               milliseconds_left(program, hearing.timeout_s, start)) <= 0)
      continue;
    if (waiting[1].revents != 0 && has_closed(closing, hearing.until_closed)) return true;
    if (waiting[0].revents == 0) continue;
    const auto said = read_some(words);
    if (said.empty()) return false;
    if (hearing.hear) hearing.hear(said);
  }
}

}  // namespace

std::string own_output(const Handle&) { return "/dev/fd/1"; }

std::string program_file(const std::string& name, const Installation&) { return name; }

/// The descriptors of both ends are 3 or more, so that a child does not overwrite them with its standard streams.
Pipe::Pipe() {
  int ends[2];
  if (!make_pipe(ends)) refuse_pipe();
  const Handle low_out(ends[0]), low_in(ends[1]);
  out = Handle(::fcntl(ends[0], F_DUPFD_CLOEXEC, 3));
  in = Handle(::fcntl(ends[1], F_DUPFD_CLOEXEC, 3));
  if (!out || !in) refuse_pipe();
}

std::string read_some(const Handle& pipe) {
  std::array<char, 4096> buffer;
  for (;;) {
    const auto count = ::read(descriptor_of(pipe), buffer.data(), buffer.size());
    if (count >= 0 || errno != EINTR)
      return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }
}

RunningProgram::~RunningProgram() {
  if (id <= 0) return;
  ::kill(static_cast<pid_t>(leads_group ? -id : id), SIGKILL);
  status();
}

int RunningProgram::status() {
  int result = 0;
  while (::waitpid(static_cast<pid_t>(id), &result, 0) < 0 && errno == EINTR) continue;
  id = 0;
  return result;
}

/// Uses fork, because posix_spawn cannot ensure that the child ends when this process ends.
void start(RunningProgram& running, const Program& program, const Streams& streams) {
  auto words = program.words, variables = environment_with(program.variables);
  const auto arguments = pointers_to(words), environment = pointers_to(variables);
  Pipe failed;
  const pid_t ourselves = ::getpid();
  running.leads_group = program.outlives_us;
  running.id = ::fork();
  if (running.id == 0) {
    become(arguments.data(), environment.data(), program, streams, ourselves);
    const int why = errno;
    [[maybe_unused]] const auto written = ::write(descriptor_of(failed.in), &why, sizeof why);
    ::_exit(127);
  }
  const int not_forked = running.id < 0 ? errno : 0;
  failed.in.close();
  const int failure = not_forked ? not_forked : failure_of(failed.out);
  if (failure == 0) return;
  if (failure == ENOENT)
    throw Error(fmt::format("{}: not found; install the package {}", words[0], program.package));
  throw Error(fmt::format("{}: cannot be run: {}", words[0], std::strerror(failure)));
}

bool run_heard(const Program& program, const Hearing& hearing) {
  Pipe words;
  const auto closing = watch(program.folder, hearing.until_closed);
  RunningProgram running;
  start(running, program, {.output = hearing.result, .error = &words.in});
  words.in.close();
  if (listen(words.out, closing, program, hearing)) return true;
  const int status = running.status();
  if (WIFSIGNALED(status))
    throw Error(fmt::format("{}: ended by signal {}", program.words[0], WTERMSIG(status)));
  return WEXITSTATUS(status) == 0;
}

}  // namespace coppermoon::files
