// SPDX-License-Identifier: MIT
#include "verbs/number_list.h"

#include <CLI/CLI.hpp>

namespace coppermoon::verbs {

std::optional<std::vector<double>> number_list(const std::string& text) {
  std::vector<double> numbers;
  if (text.empty()) return numbers;
  for (const auto& part : CLI::detail::split(text, ',')) {
    double number = 0;
    if (!CLI::detail::lexical_cast(part, number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace coppermoon::verbs
