// SPDX-License-Identifier: MIT
#include "verbs/flags/number_with_unit.h"

#include <string_view>

#include "algebra/number.h"

namespace coppermoon::verbs {

std::optional<double> number_with_unit(const std::string& text,
                                       const std::vector<std::pair<std::string, double>>& units) {
  for (const auto& [unit, size] : units) {
    if (!text.ends_with(unit)) continue;
    const auto digits = std::string_view(text).substr(0, text.size() - unit.size());
    if (const auto number = algebra::number_in(digits)) return *number * size;
  }
  return std::nullopt;
}

}  // namespace coppermoon::verbs
