// SPDX-License-Identifier: MIT
#include "atmosphere/tropopause.h"

#include "support/testing.h"

namespace coppermoon::atmosphere::tropopause_test {

using algebra::degrees;

// The formula of the same paper, whose figures were read elsewhere than the table's: with
// 3.5 units of potential vorticity, mean of the year.
double by_formula_km(double latitude) {
  return latitude < 0
             ? 8.7796 + 7.5417 / std::pow(1 + std::exp(-(latitude + 26.73) / 1.1474), 0.087)
             : 8.499 + 7.8229 / std::pow(1 + std::exp(-(latitude - 26.7284) / -1.5804), 0.098);
}

TEST(Tropopause, LiesWhereTheFormulaOfThePaperHasItOverTheYear) {
  for (const double latitude : {-80., -60., -45., -15., 0., 15., 45., 60., 80.}) {
    double mean = 0;
    for (int month = 0; month < 12; ++month)
      mean += tropopause_m(degrees(latitude), 2001 + (month + 0.5) / 12) / 12e3;
    EXPECT_WITHIN(mean, by_formula_km(latitude), 0.7, "the formula is good to 0.88 km of balloons")
        << latitude;
  }
}

TEST(Tropopause, HasTheTablesHeights) {
  EXPECT_WITHIN(tropopause_m(degrees(32.5), 2001 + 16 / 365.25), 13238, 1e-6,
                "a node of the table");
  EXPECT_WITHIN(tropopause_m(degrees(90), 2001 + 16 / 365.25), 8767, 1e-6, "held beyond 85°");
  EXPECT_THROW(tropopause_m(degrees(-91), 2001), algebra::Error);
}

TEST(Tropopause, RunsOnOverTheNewYear) {
  const double before = tropopause_m(degrees(37.5), 2001.9999),
               after = tropopause_m(degrees(37.5), 2002.0001);
  EXPECT_WITHIN(before, after, 2, "a tenth of a day of 5 km a year");
  EXPECT_GT(before, 10937) << "between December's 11 557 m and January's 10 937 m";
  EXPECT_LT(before, 11557);
}

}  // namespace coppermoon::atmosphere::tropopause_test
