// SPDX-License-Identifier: MIT
#include "verbs/reports/writers.h"

#include <fmt/chrono.h>

#include <ctime>

#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {

bool has_ending(const std::vector<std::string>& names, std::string_view ending) {
  return std::ranges::any_of(names, [&](const std::string& name) {
    return std::filesystem::path(name).extension() == ending;
  });
}

void print_names(const std::vector<std::string>& names) {
  if (!names.empty()) fmt::print("\n");
  for (const auto& name : names) fmt::print("{}\n", one_line(name));
}

void print_json(result::Json document, const std::vector<std::string>& files) {
  if (!files.empty()) document["files"] = files;
  fmt::print("{}\n", document.dump(2));
}

almanac::Instant now() {
  return almanac::instant_from_utc(fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr))));
}

}  // namespace coppermoon::verbs
