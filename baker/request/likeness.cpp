// SPDX-License-Identifier: MIT
#include "request/likeness.h"

#include <algorithm>
#include <numeric>

namespace coppermoon::request {

std::size_t letters_apart(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0U);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  word = word.substr(0, 100);  // all known words are shorter than this
  return *std::ranges::min_element(known, {},
                                   [&](const auto& one) { return letters_apart(word, one); });
}

}  // namespace coppermoon::request
