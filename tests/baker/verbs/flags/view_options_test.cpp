// SPDX-License-Identifier: MIT
#include "verbs/flags/view_options.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "support/within.h"

namespace coppermoon::verbs {
namespace {

constexpr const char* reason = "rounding between degrees and radians";

TEST(ObserverFrom, ReadsLatitudeLongitudeAndElevation) {
  const auto place = observer_from("42.86,-73.77,120");
  EXPECT_WITHIN(in_degrees(place.latitude), 42.86, 1e-12, reason);
  EXPECT_WITHIN(in_degrees(place.longitude), -73.77, 1e-12, reason);
  EXPECT_WITHIN(in_metres(place.elevation), 120, 1e-12, reason);
}

TEST(ObserverFrom, StandsAtSeaLevelUnlessToldOtherwise) {
  EXPECT_EQ(in_metres(observer_from("-33.9,18.4").elevation), 0);
}

TEST(ObserverFrom, RefusesWhatIsNoPlace) {
  for (const char* text :
       {"", "42", "42,", "42,x", "1,2,3,4", "91,0", "-90.1,0", "0,361", "nan,0", "42 -73"})
    EXPECT_THROW(observer_from(text), algebra::Error) << text;
}

}  // namespace
}  // namespace coppermoon::verbs
