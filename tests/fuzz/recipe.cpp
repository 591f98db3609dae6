// SPDX-License-Identifier: MIT
// A recipe, read for the word that its first byte chooses.
#include "fuzz/silent_program.h"

namespace {

using namespace coppermoon;

/// Word and flags that its recipes may leave out.
fuzz::Words command(std::size_t chosen, const std::string& recipe) {
  constexpr const char* instant = "2008-02-21T03:26:05Z";
  const std::vector<fuzz::Words> commands{{"bake", instant, "-o", "a.exr"},
                                          {"scene", instant, "-o", "a"},
                                          {"still", instant, "-o", "a.png"},
                                          {"plan", instant},
                                          {"shadow", instant},
                                          {"ring", instant, "-o", "a.exr"},
                                          {"brightness", instant},
                                          {"sky", instant},
                                          {"almanac", "--from=2008-01-01", "--to=2009-01-01"},
                                          {"develop", "a.exr", "-o", "a"},
                                          {"merge", "a.exr", "-o", "a"},
                                          {"compare", "a.png", "a.exr"},
                                          {"fit", "a.png", "--instants", instant},
                                          {"tradeoff", "-o", "a"}};
  auto words = commands[chosen % commands.size()];
  words.insert(words.begin() + 1, {"--recipe", recipe});
  return words;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  static const fuzz::ScratchFile file("recipe.toml");
  file.holding(fuzz::as_text(data, size).substr(1));
  fuzz::require_lasting_recipe(command(data[0], file.path().string()));
  return 0;
}
