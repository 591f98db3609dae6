// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "plan/plan.h"

namespace coppermoon::verbs {

/// What a verb that made a file has to say.
struct Report {
  std::vector<std::string> files;
  std::string recipe;
  double seconds, relative_error;
  plan::Plan plan;
};

/// Seconds from a time on until now.
double seconds_since(std::chrono::steady_clock::time_point start);

/// On stdout: one line, or one JSON document with the keys file (files where there are several),
/// chosen, left_out, predicted and reached.
void report(const Report& made, bool json);

/// A recipe as JSON.
nlohmann::ordered_json as_json(const std::string& recipe);

/// Rows as CSV under the names of their columns: an array of objects with the same keys, none nested. Null is empty.
std::string as_csv(const nlohmann::ordered_json& rows);

/// `left_out` and `predicted`, `methods` and `gave_way` where there is more than one, or one did.
nlohmann::ordered_json as_json(const plan::Plan& plan);

}  // namespace coppermoon::verbs
