// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "verbs/command_line.h"
#include "verbs/reports/one_line.h"

namespace {

namespace verbs = coppermoon::verbs;

constexpr int could_not = 1, wrong_usage = 2;

/// An error, whoever wrote it.
void say(std::string_view error) {
  std::fputs(fmt::format("coppermoon: {}\n", verbs::one_line(error)).c_str(), stderr);
}

/// Opens closed standard descriptors on /dev/null, so that no file opened later takes their numbers and is written into.
/// The direction is the wrong one, so that reading or printing fails as it does on a closed one.
void hold_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0)
      ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

/// Standard error that never fails: who does not hear what is said beside the results loses nothing else.
void speak_to_whoever_hears() {
  cookie_io_functions_t voice{};
  voice.write = [](void*, const char* words, std::size_t size) -> ssize_t {
    const auto heard = ::write(STDERR_FILENO, words, size);
    return heard > 0 ? heard : static_cast<ssize_t>(size);
  };
  FILE* const error = ::fopencookie(nullptr, "w", voice);
  if (error == nullptr) return;
  std::setvbuf(error, nullptr, _IONBF, 0);
  stderr = error;
}

/// What a thread that cannot begin, or a library's promise not to throw, make of too little memory.
[[noreturn]] void end_at_once() {
  constexpr std::string_view why = "coppermoon: not enough memory\n";
  [[maybe_unused]] const auto said = ::write(STDERR_FILENO, why.data(), why.size());
  std::_Exit(could_not);
}

/// Time zones of a portable archive, where the system has none.
void find_time_zones() {
  std::error_code failed;
  if (std::filesystem::exists("/usr/share/zoneinfo", failed)) return;
  const auto own =
      std::filesystem::read_symlink("/proc/self/exe", failed).parent_path() / "../share/zoneinfo";
  if (std::filesystem::exists(own, failed)) ::setenv("TZDIR", own.c_str(), 0);
}

/// Memory that was freed is used again, not given back: pages of the system cost a tenth of a texture's time.
void keep_freed_memory() {
  constexpr int largest_kept = 1 << 30;
  ::mallopt(M_MMAP_THRESHOLD, largest_kept);
  ::mallopt(M_TRIM_THRESHOLD, largest_kept);
}

int run(int count, char** words) {
  try {
    verbs::Program program;
    add_verbs(program);
    const auto [verb, text] = asked_by(program, {words + std::min(count, 1), words + count});
    if (text.empty())
      run(*verb);
    else
      fmt::print("{}", text);
    return 0;
  } catch (const verbs::WrongUsage& error) {
    say(error.what());
    return wrong_usage;
  } catch (const std::bad_alloc&) {
    say("not enough memory");
    return could_not;
  } catch (const std::exception& error) {
    say(error.what());
    return could_not;
  }
}

}  // namespace

int main(int count, char** words) {
  keep_freed_memory();
  hold_standard_descriptors();
  speak_to_whoever_hears();
  std::signal(SIGXFSZ, SIG_IGN);  // a file too large is an error like any other, said in one line
  std::set_terminate(end_at_once);
  // OpenImageIO brings OpenBLAS along, whose threads nobody needs: where memory is short they never end
  ::setenv("OPENBLAS_NUM_THREADS", "1", 0);
  find_time_zones();
  const int status = run(count, words);
  const bool all_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (all_written || status != 0) return status;
  say("standard output: cannot be written");
  return could_not;
}
