// SPDX-License-Identifier: MIT
#include "files/child_process.h"

#include <fmt/format.h>

#include "algebra/error.h"
#include "files/file_end.h"
#include "files/running_program.h"

namespace coppermoon::files {
namespace {

using algebra::Error;

/// A callback that appends a program's messages to `said` until `said` has 4096 bytes.
auto kept_in(std::string& said) {
  return [&said](std::string_view words) {
    constexpr std::size_t most = 4096;
    if (said.size() < most) said += words;
  };
}

/// The last non-empty line of a string.
std::string last_line(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

/// The first non-empty line of a string.
std::string first_line(std::string text) {
  text.erase(0, text.find_first_not_of('\n'));
  return text.substr(0, text.find('\n'));
}

}  // namespace

Error not_done(const Program& program, double timeout_s) {
  return Error(
      fmt::format("{}: not done after {:g} s, the time allowed", program.words[0], timeout_s));
}

void run_program(const Program& program, const Handle* result) {
  std::string said;
  if (!run_heard(program, {.result = result, .hear = kept_in(said)}))
    throw Error(fmt::format("{}: {}", program.words[0], first_line(said)));
  if (result) require_whole(*result, program.words[0]);
}

void require_whole(const Handle& file, const std::string& by) {
  const auto size = size_of(file);
  if (size == 0) throw Error(fmt::format("{}: ended without a result", by));
  if (!has_its_end(file))
    throw Error(fmt::format("{}: its file is cut off after {} bytes; is the disk full?", by, size));
}

std::string output_of(const Program& program) {
  Pipe output;
  std::string said, made;
  const bool well = run_heard(program, {.result = &output.in, .hear = kept_in(said)});
  output.in.close();
  if (!well) throw Error(last_line(said));
  for (std::string more; !(more = read_some(output.out)).empty();) made += more;
  return made;
}

}  // namespace coppermoon::files
