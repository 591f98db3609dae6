// SPDX-License-Identifier: MIT
#include "algebra/number.h"

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

}  // namespace coppermoon::algebra
