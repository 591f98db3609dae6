// SPDX-License-Identifier: MIT
#include "uses/light/shard.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "algebra/number.h"

namespace coppermoon::uses {

Shard shard_from(const std::string& text) {
  constexpr std::size_t most = 100000;
  const auto slash = std::min(text.find('/'), text.size());
  const auto number = [](std::string_view digits) {
    return algebra::whole_number(digits).value_or(0);
  };
  const auto part = number(text.substr(0, slash)),
             parts = number(slash == text.size() ? "" : text.substr(slash + 1));
  if (part < 1 || part > parts || parts > most)
    throw algebra::Error(
        fmt::format("shard = {}, allowed K/N, as 2/8: K from 1 to N, N to {}", text, most));
  return {part, parts};
}

}  // namespace coppermoon::uses
