// SPDX-License-Identifier: MIT
#include "verbs/flags/known_words.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <numeric>

namespace coppermoon::verbs {
namespace {

/// Number of letters to insert, drop or change to make one word of the other.
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

}  // namespace

std::vector<std::string> long_flags(const CLI::App& verb) {
  std::vector<std::string> flags;
  for (const auto* option : verb.get_options())
    for (const auto& name : option->get_lnames()) flags.push_back(name);
  return flags;
}

std::vector<std::string> flags_added_by(const std::function<void(CLI::App&)>& add) {
  CLI::App verb;
  add(verb);
  return long_flags(verb);
}

bool holds(const std::vector<std::string>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

std::string nearest(std::string_view word, const std::vector<std::string>& known) {
  word = word.substr(0, 100);  // longer than any that is known
  return *std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return letters_apart(word, a) < letters_apart(word, b);
  });
}

}  // namespace coppermoon::verbs
