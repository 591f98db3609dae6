// SPDX-License-Identifier: MIT
#include "uses/fit/magnitudes.h"

#include "baker/texture/scratch_folder.h"
#include "support/testing.h"

namespace magnitudes_test {

using namespace coppermoon;

class MagnitudeLists : public ScratchFolder {
 protected:
  std::vector<uses::MeasuredMagnitude> read(const std::string& text) const {
    return uses::read_magnitudes(file("a.csv", text));
  }
};

const std::string names = "instant,band,magnitude,error\n", three = "instant,band,magnitude\n",
                  eclipsed = "2018-07-27T20:40:00Z,V,";

TEST_F(MagnitudeLists, HoldWhatWasMeasured) {
  const auto all = read("# by eye\n" + names + eclipsed + "-1.5,0.2\n\n" + eclipsed + "-1.25,\n");
  ASSERT_EQ(all.size(), 2);
  EXPECT_EQ(almanac::utc_text(all[0].instant), "2018-07-27T20:40:00Z");
  EXPECT_EQ(all[0].band, "V");
  EXPECT_EQ(all[0].magnitude, -1.5);
  EXPECT_EQ(all[0].error, 0.2);
  EXPECT_EQ(all[1].error, 0.1) << "what is taken where the measurer does not tell";
  EXPECT_EQ(read(three + eclipsed + "2\n")[0].error, 0.1);
}

TEST_F(MagnitudeLists, MayNameTheirColumnsInAnyOrder) {
  const auto all = read("band,error,magnitude,instant\nR,0.3,-2,2018-07-27T20:40:00Z\n");
  EXPECT_EQ(all[0].band, "R");
  EXPECT_EQ(all[0].error, 0.3);
  EXPECT_EQ(all[0].magnitude, -2);
}

TEST_F(MagnitudeLists, OfSpreadsheetsMayBeginWithAByteOrderMarkAndEndLinesInTheirWay) {
  const auto all = read("\xEF\xBB\xBFinstant,band,magnitude,error\r\n" + eclipsed + "-1.5,0.2\r\n");
  ASSERT_EQ(all.size(), 1);
  EXPECT_EQ(all[0].magnitude, -1.5);
  EXPECT_EQ(all[0].error, 0.2);
}

TEST_F(MagnitudeLists, WithDecimalCommasAreRefused) {
  EXPECT_ERROR(read(three + eclipsed + "-1,5\n"),
               "a.csv:2: 4 columns, allowed 3 as in the first line, and decimal points, no commas, "
               "in numbers");
  EXPECT_ERROR(read(names + eclipsed + "-1,5,0,2\n"), "a.csv:2: 6 columns, allowed 4");
  EXPECT_ERROR(read(names + eclipsed + "-1,5,0.2\n"), "a.csv:2: 5 columns, allowed 4");
  for (const char* behind : {"5", "1", "05", "25", "0"})  // in the place of an error
    EXPECT_ERROR(read(names + eclipsed + "-1," + behind + "\n"), "allowed 0.001 to 0.99");
  EXPECT_ERROR(read("instant;band;magnitude\n2018-07-27T20:40:00Z;V;-1,5\n"),
               "a.csv:1: columns = instant;band;magnitude, allowed instant, band, magnitude");
}

TEST_F(MagnitudeLists, OfOtherColumnsAreRefused) {
  for (const char* columns :
       {"instant,band,magnitude,magnitude", "instant,band,magnitude,error,error",
        "instant,band,magnitude,error,observer", "instant,band,magnitude,",
        "Instant,band,magnitude", "instant,band", "instant,instant,band,magnitude"})
    EXPECT_ERROR(read(columns + std::string("\n") + eclipsed + "-1,0.2,0.2\n"),
                 "a.csv:1: columns = " + std::string(columns) + ", allowed instant, band,");
}

TEST_F(MagnitudeLists, OfLinesThatAreShorterOrLongerThanTheFirstAreRefused) {
  EXPECT_ERROR(read(names + eclipsed + "-1\n"), "a.csv:2: a line of fewer columns than the first");
  EXPECT_ERROR(read(names + eclipsed + "-1,0.2,\n"), "a.csv:2: 5 columns, allowed 4");
  EXPECT_ERROR(read(names + eclipsed + "-1,0.2,cloudy\n"), "a.csv:2: 5 columns, allowed 4");
}

}  // namespace magnitudes_test
