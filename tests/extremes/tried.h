// SPDX-License-Identifier: MIT
// Rows of the table of extremes, which tests/measurements/extremes.sh gathers from what the tests print.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace coppermoon::extremes {

/// A text as a cell of a Markdown table; of a long one the middle is left out.
inline std::string cell(std::string_view text) {
  constexpr std::size_t most = 200;
  std::string all;
  for (const char c : text) all += c == '|' ? std::string("\\|") : std::string(1, c);
  return all.size() <= most ? all
                            : all.substr(0, most / 2) + " ... " + all.substr(all.size() - most / 2);
}

/// What was pushed how far, what holds there, and how near it came.
///
/// Given  holds  a fact with its unit, as "bending, over itself"
///        bound  that the test asserts
///        worst  that was seen
inline void tried(std::string_view what, std::string_view holds, double bound, double worst) {
  fmt::print("| {} | {} | {:.2g} | {:.2g} |\n", cell(what), cell(holds), bound, worst);
}

/// The same for a fact without a number, as "the same bytes".
inline void tried(std::string_view what, std::string_view holds) {
  fmt::print("| {} | {} | | |\n", cell(what), cell(holds));
}

/// What is refused, and the line that says so.
inline void refused(std::string_view what, std::string_view message) {
  fmt::print("| {} | refused | | `{}` |\n", cell(what), cell(message));
}

}  // namespace coppermoon::extremes
