// SPDX-License-Identifier: MIT
#include "verbs/reports/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <sstream>

#include "verbs/reports/in_words.h"
#include "verbs/reports/one_line.h"

namespace coppermoon::verbs {

nlohmann::ordered_json as_json(const std::string& recipe) {
  std::ostringstream text;
  text << toml::json_formatter(toml::parse(recipe));
  return nlohmann::ordered_json::parse(text.str());
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void report(const Report& made, bool json) {
  if (!json) {
    std::vector<std::string> names;
    for (const auto& file : made.files) names.push_back(one_line(file));
    fmt::print("{}: made in {}, {}\n", fmt::join(names, ", "), duration(made.seconds),
               within(made.relative_error));
    if (made.plan.exceeds_budget)
      fmt::print(stderr, "coppermoon: the budget is too short for any light: {} are predicted\n",
                 duration(made.plan.seconds));
    else if (made.plan.misses_tolerance)
      fmt::print(stderr, "coppermoon: the tolerance cannot be reached: {} is predicted\n",
                 in_percent(made.plan.error));
    return;
  }
  fmt::print("{}\n", result::as_json(made).dump(2));
}

}  // namespace coppermoon::verbs
