// SPDX-License-Identifier: MIT
// Writes manual pages and completions into a folder: coppermoon_manuals FOLDER
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>

#include "files/whole_file.h"
#include "verbs/command_line.h"
#include "verbs/manuals/completions.h"
#include "verbs/manuals/manual_page.h"

namespace {

namespace verbs = coppermoon::verbs;

void write_all(const std::filesystem::path& folder) {
  using coppermoon::files::write_whole;
  std::filesystem::create_directories(folder);
  verbs::Program program;
  add_verbs(program);
  write_whole(folder / "coppermoon.1", verbs::program_manual_page(program));
  for (const auto& verb : program.verbs)
    write_whole(folder / fmt::format("coppermoon-{}.1", verb.name),
                verbs::manual_page(verb));
  write_whole(folder / "coppermoon.bash", verbs::bash_completion(program));
  write_whole(folder / "coppermoon.zsh", verbs::zsh_completion(program));
  write_whole(folder / "coppermoon.fish", verbs::fish_completion(program));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 2;
  try {
    write_all(arguments[1]);
    return 0;
  } catch (const std::exception& error) {
    std::fputs(fmt::format("coppermoon_manuals: {}\n", error.what()).c_str(), stderr);
    return 1;
  }
}
