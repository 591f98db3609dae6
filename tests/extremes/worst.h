// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string_view>

#include "algebra/error.h"
#include "extremes/tried.h"
#include "support/within.h"

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

/// What the action throws as algebra::Error; a failure when it throws none.
template <class Action>
void is_refused(std::string_view what, const Action& action) {
  try {
    action();
    ADD_FAILURE() << what << " is not refused";
  } catch (const algebra::Error& error) {
    EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
    EXPECT_NE(std::string_view(error.what()).find(" to "), std::string_view::npos)
        << "what is allowed? " << error.what();
    refused(what, error.what());
  }
}

}  // namespace coppermoon::extremes
