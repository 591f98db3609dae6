// SPDX-License-Identifier: MIT
#include "verbs/number_with_unit.h"

#include <CLI/CLI.hpp>

namespace coppermoon::verbs {

std::optional<double> number_with_unit(const std::string& text,
                                       const std::vector<std::pair<std::string, double>>& units) {
  for (const auto& [unit, size] : units) {
    double number = 0;
    if (text.ends_with(unit) &&
        CLI::detail::lexical_cast(text.substr(0, text.size() - unit.size()), number))
      return number * size;
  }
  return std::nullopt;
}

}  // namespace coppermoon::verbs
