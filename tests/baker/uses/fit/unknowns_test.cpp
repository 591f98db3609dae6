// SPDX-License-Identifier: MIT
#include "uses/fit/unknowns.h"

#include "support/testing.h"
#include "uses/light/light_parameters.h"

namespace coppermoon::uses::unknowns_test {

TEST(Unknowns, AreFactorsWhereTheAirHasAMonth) {
  EXPECT_EQ(usual_unknowns({}), Unknowns::factors);
  EXPECT_EQ(usual_unknowns({.atmosphere = "calibrated"}), Unknowns::factors);
  EXPECT_EQ(usual_unknowns({.atmosphere = "undated"}), Unknowns::amounts);
  EXPECT_EQ(usual_unknowns({.column = {.cloud_cover = 0.4}}), Unknowns::amounts);
}

TEST(Unknowns, HaveThePlaceAndTheNameOfAParameterOfTheAir) {
  for (const auto unknowns : {Unknowns::factors, Unknowns::amounts}) {
    const AirNumbers numbers{0.7, 0.6, 0.9};
    auto air = with_unknowns({}, unknowns, numbers);
    request::Parameters described;
    describe(described, air);
    for (std::size_t a = 0; a < numbers.size(); ++a) {
      const auto& unknown = unknowns_of(unknowns)[a];
      const auto parameter =
          std::ranges::find(described, unknown.parameter, [](const auto& one) { return one.name; });
      ASSERT_NE(parameter, described.end()) << unknown.parameter;
      EXPECT_EQ(std::stod(parameter->text()), numbers[a]);
      EXPECT_WITHIN_RELATIVE(unknown.from_axis(unknown.on_axis(unknown.most)), unknown.most, 1e-14,
                             "rounding");
    }
  }
}

TEST(Unknowns, OfAMonthAreNearTheMonths) {
  const auto& [aerosol, cloud, ozone] = unknowns_of(Unknowns::factors);
  for (const auto* unknown : {&aerosol, &cloud}) {
    EXPECT_EQ(unknown->chi_squared_of_prior(0), 0);
    EXPECT_WITHIN(unknown->chi_squared_of_prior(-1.4), 4, 1e-12, "twice 0.7, squared");
  }
  EXPECT_WITHIN(ozone.chi_squared_of_prior(1.15), 1, 1e-12, "0.15, squared");
  for (const auto& unknown : unknowns_of(Unknowns::amounts))
    EXPECT_EQ(unknown.chi_squared_of_prior(unknown.on_axis(unknown.most)), 0) << "uniform";
}

}  // namespace coppermoon::uses::unknowns_test
