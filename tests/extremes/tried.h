// SPDX-License-Identifier: MIT
// Rows of the table of extremes, which examples/extremes.sh gathers from what the tests print.
#pragma once

#include <fmt/format.h>

#include <string_view>

namespace coppermoon::extremes {

/// What was pushed how far, what holds there, and how near it came.
///
/// Given  holds  a fact with its unit, as "bending, over itself"
///        bound  that the test asserts
///        worst  that was seen
inline void tried(std::string_view what, std::string_view holds, double bound, double worst) {
  fmt::print("| {} | {} | {:.2g} | {:.2g} |\n", what, holds, bound, worst);
}

/// The same for a fact without a number, as "the same bytes".
inline void tried(std::string_view what, std::string_view holds) {
  fmt::print("| {} | {} | | |\n", what, holds);
}

/// What is refused, and the line that says so.
inline void refused(std::string_view what, std::string_view message) {
  fmt::print("| {} | refused | | `{}` |\n", what, message);
}

}  // namespace coppermoon::extremes
