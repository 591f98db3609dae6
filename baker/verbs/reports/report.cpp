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

nlohmann::ordered_json as_json(const plan::Plan& plan) {
  nlohmann::ordered_json all{{"left_out", nlohmann::ordered_json::array()},
                             {"predicted", {{"seconds", plan.seconds}, {"error", plan.error}}}};
  for (const auto& [term, size] : plan.left_out)
    all["left_out"].push_back({{"term", name(term)}, {"size", size}});
  for (const auto& [solver, seconds, error] : plan.methods)
    all["methods"].push_back({{"method", name(solver)}, {"seconds", seconds}, {"error", error}});
  if (plan.misses_tolerance) all["gave_way"] = "tolerance";
  if (plan.exceeds_budget) all["gave_way"] = "budget";
  return all;
}

std::string as_csv(const nlohmann::ordered_json& rows) {
  std::string text;
  for (const auto& row : rows) {
    std::vector<std::string> names, cells;
    for (const auto& [name, value] : row.items()) {
      names.push_back(name);
      cells.push_back(value.is_null()     ? ""
                      : value.is_string() ? value.get<std::string>()
                                          : value.dump());
    }
    if (text.empty()) text = fmt::format("{}\n", fmt::join(names, ","));
    text += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return text;
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
  nlohmann::ordered_json all;
  if (made.files.size() == 1)
    all["file"] = made.files.front();
  else
    all["files"] = made.files;
  all["chosen"] = as_json(made.recipe);
  all.update(as_json(made.plan));
  all["reached"] = {{"seconds", made.seconds}, {"error", made.relative_error}};
  fmt::print("{}\n", all.dump(2));
}

}  // namespace coppermoon::verbs
