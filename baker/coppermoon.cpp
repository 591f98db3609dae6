// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

#include "files/environment.h"
#include "files/loaded_library.h"
#include "files/memory.h"
#include "files/standard_streams.h"
#include "verbs/command_line.h"
#include "verbs/reports/one_line.h"

namespace {

namespace files = coppermoon::files;
namespace verbs = coppermoon::verbs;

constexpr int could_not = 1, wrong_usage = 2;

/// Prints an error message on stderr as one line.
void say(std::string_view error) {
  std::fputs(fmt::format("coppermoon: {}\n", verbs::one_line(error)).c_str(), stderr);
}

/// Ends the program if memory runs out where no exception can be caught: when a thread cannot start, or in a library
/// function that promises not to throw.
[[noreturn]] void end_at_once() {
  files::say_at_once("coppermoon: not enough memory\n");
  std::_Exit(could_not);
}

/// Uses the time zones that come with a portable archive of the program if the system has none.
void find_time_zones() {
  std::error_code failed;
  const std::filesystem::path systems = "/usr/share/zoneinfo";
  if (systems.is_absolute() && std::filesystem::exists(systems, failed)) return;
  const auto own = files::own_program().parent_path() / "../share/zoneinfo";
  if (std::filesystem::exists(own, failed)) files::set_missing_variable("TZDIR", own.string());
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
  files::keep_freed_memory();
  files::prepare_standard_streams();
  std::set_terminate(end_at_once);
  // OpenImageIO loads OpenBLAS. Its threads are not needed, and starting them hangs if memory is short.
  files::set_missing_variable("OPENBLAS_NUM_THREADS", "1");
  find_time_zones();
  const int status = run(count, words);
  const bool all_written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (all_written || status != 0) return files::end_program(status);
  say("standard output: cannot be written");
  return files::end_program(could_not);
}
