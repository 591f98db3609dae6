// SPDX-License-Identifier: MIT
// A command line, a word a line.
#include <algorithm>
#include <sstream>

#include "fuzz/silent_program.h"

namespace {

using namespace coppermoon;

fuzz::Words words_of(std::string text) {
  std::ranges::replace(text, '\0', '\n');
  fuzz::Words words;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) words.push_back(line);
  return words;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::require_lasting_recipe(words_of(std::string(fuzz::as_text(data, size))));
  return 0;
}
