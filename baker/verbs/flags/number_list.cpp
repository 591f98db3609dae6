// SPDX-License-Identifier: MIT
#include "verbs/flags/number_list.h"

#include <algorithm>
#include <string_view>

#include "algebra/number.h"

namespace coppermoon::verbs {

std::optional<std::vector<double>> number_list(const std::string& text) {
  std::vector<double> numbers;
  if (text.empty()) return numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    const auto number = algebra::number_in(std::string_view(text).substr(begin, end - begin));
    if (!number) return {};
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

}  // namespace coppermoon::verbs
