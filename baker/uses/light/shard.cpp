// SPDX-License-Identifier: MIT
#include "uses/light/shard.h"

#include <fmt/format.h>

#include "algebra/error.h"

namespace coppermoon::uses {

std::optional<std::size_t> whole_number(const std::string& text) {
  std::size_t number = 0;
  if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  for (const char digit : text) number = 10 * number + static_cast<std::size_t>(digit - '0');
  return number;
}

Shard shard_from(const std::string& text) {
  constexpr std::size_t most = 100000;
  const auto slash = text.find('/');
  const auto part = whole_number(text.substr(0, slash)).value_or(0),
             parts =
                 whole_number(slash == std::string::npos ? "" : text.substr(slash + 1)).value_or(0);
  if (part < 1 || part > parts || parts > most)
    throw algebra::Error(
        fmt::format("shard = {}, allowed K/N, as 2/8: K from 1 to N, N to {}", text, most));
  return {part, parts};
}

}  // namespace coppermoon::uses
