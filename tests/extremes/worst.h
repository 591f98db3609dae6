// SPDX-License-Identifier: MIT
#pragma once

#include "extremes/tried.h"
#include "support/testing.h"

namespace coppermoon::extremes {

/// The largest of what was seen; once no number, no number for good.
struct Worst {
  double value = 0;

  void see(double error) {
    if (!std::isnan(value) && !(error <= value)) value = error;
  }
  void see_relative(double found, double reference) {
    see(found == reference ? 0 : std::abs(found / reference - 1));
  }
};

/// Expects it within the bound, and prints the row.
inline void holds(std::string_view what, std::string_view fact, double bound, const Worst& worst,
                  std::string_view reason) {
  EXPECT_WITHIN(worst.value, 0., bound, reason) << " " << what;
  tried(what, fact, bound, worst.value);
}

/// Expects a refusal in one line that says what is allowed, and prints the row.
template <class Action>
void is_refused(std::string_view what, const Action& action) {
  const auto said = refusal_of(action);
  EXPECT_NE(said, "") << what << " is not refused";
  EXPECT_SAYS_NOT(said, '\n');
  EXPECT_SAYS(said, " to ") << "what is allowed? " << said;
  refused(what, said);
}

}  // namespace coppermoon::extremes
