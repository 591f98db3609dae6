// SPDX-License-Identifier: MIT
#include "verbs/report.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <nlohmann/json.hpp>
#include <sstream>

namespace coppermoon::verbs {

void report(const Report& made, bool json) {
  if (!json) {
    fmt::print("{}: {:.1f} s, error {:.2g}\n", made.file, made.seconds, made.relative_error);
    return;
  }
  std::ostringstream chosen;
  chosen << toml::json_formatter(toml::parse(made.recipe));
  const nlohmann::ordered_json all{
      {"file", made.file},
      {"chosen", nlohmann::ordered_json::parse(chosen.str())},
      {"reached", {{"seconds", made.seconds}, {"error", made.relative_error}}}};
  fmt::print("{}\n", all.dump(2));
}

}  // namespace coppermoon::verbs
