// SPDX-License-Identifier: MIT
#include "algebra/number.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace coppermoon::algebra {

std::optional<double> number_in(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double number = 0;
  const auto* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
  return number;
}

std::optional<double> number_with_unit(
    std::string_view text, const std::vector<std::pair<std::string_view, double>>& units) {
  for (const auto& [unit, size] : units) {
    if (!text.ends_with(unit)) continue;
    if (const auto number = number_in(text.substr(0, text.size() - unit.size())))
      return *number * size;
  }
  return std::nullopt;
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  if (text.empty()) return numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    const auto number = number_in(text.substr(begin, end - begin));
    if (!number) return {};
    numbers.push_back(*number);
    begin = end + 1;
  }
  return numbers;
}

}  // namespace coppermoon::algebra
