// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "plan/plan.h"

namespace coppermoon::verbs {

/// Report of a command that made files.
struct Report {
  std::vector<std::string> files;
  std::string recipe;
  double seconds, relative_error;
  plan::Plan plan;
};

/// Seconds since a time.
double seconds_since(std::chrono::steady_clock::time_point start);

/// Prints a report on stdout: one line, or one JSON document with the keys file (files where there are several),
/// chosen, left_out, predicted and reached.
void report(const Report& made, bool json);

/// Recipe as JSON.
nlohmann::ordered_json as_json(const std::string& recipe);

/// Rows as CSV under the names of their columns: an array of objects with the same keys, none nested. Null is empty.
std::string as_csv(const nlohmann::ordered_json& rows);

/// Plan as JSON: `left_out`, `predicted`; `methods` where several were weighed, `gave_way` where a wish was not met.
nlohmann::ordered_json as_json(const plan::Plan& plan);

}  // namespace coppermoon::verbs
