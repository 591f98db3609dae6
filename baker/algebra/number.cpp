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

std::optional<std::size_t> whole_number(std::string_view text) {
  if (text.size() > 9 || text.find_first_not_of("0123456789") != text.npos) return std::nullopt;
  std::size_t number = 0;
  const auto* end = text.data() + text.size();
  return std::from_chars(text.data(), end, number).ec == std::errc{} ? std::optional(number)
                                                                     : std::nullopt;
}

std::string_view without_spaces(std::string_view text) {
  const auto first = std::min(text.find_first_not_of(' '), text.size());
  return text.substr(first, text.find_last_not_of(' ') + 1 - first);
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
