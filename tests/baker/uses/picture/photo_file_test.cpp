// SPDX-License-Identifier: MIT
#include "uses/picture/photo_file.h"

#include <gtest/gtest.h>

#include "algebra/error.h"

namespace coppermoon::uses {
namespace {

const std::string date = "2019:01:21 05:12:16", local = "2019-01-21T05:12:16";

std::string local_in(const std::string& text) { return clock_in(text).value().local; }

TEST(ClockIn, ReadsDatesAsCamerasWriteThem) {
  for (const char* text : {"2019:01:21 05:12:16", "2019-01-21 05:12:16", "2019/01/21 5:12:16",
                           "2019-01-21T05:12:16.25", "2019:1:21 05:12:16  "})
    EXPECT_EQ(local_in(text), local) << text;
  EXPECT_EQ(local_in("2019:01:21 05:12"), "2019-01-21T05:12:00");
  EXPECT_EQ(local_in("2019:01:21 24:12:16"), "2019-01-21T00:12:16") << "hours from 1 to 24";
  EXPECT_EQ(clock_in("2019:01:21 05:12:16+0100"), (HeaderClock{local, "+01:00"}));
  EXPECT_EQ(clock_in("2019:01:21 05:12:16Z"), (HeaderClock{local, "+00:00"}));
  EXPECT_EQ(clock_in("2019:01:21 05:12:16Z", "-05:00"), (HeaderClock{local, "-05:00"}));
}

TEST(ClockIn, ReadsOffsetsAsCamerasWriteThem) {
  const auto offset_in = [](const std::string& text) { return clock_in(date, text)->offset; };
  EXPECT_EQ(offset_in("+03:00"), "+03:00");
  EXPECT_EQ(offset_in("-5:00"), "-05:00");
  EXPECT_EQ(offset_in("+0530"), "+05:30");
  EXPECT_EQ(offset_in("Z"), "+00:00");
  for (const char* unknown : {"", "   :  ", "      "}) EXPECT_EQ(offset_in(unknown), std::nullopt);
  for (const char* odd : {"05:00", "+99:00", "EST", "+5:0"})
    EXPECT_THROW(offset_in(odd), algebra::Error) << odd;
}

TEST(ClockIn, KnowsACameraWhoseClockWasNotSet) {
  for (const char* blank :
       {"", "    :  :     :  :  ", "0000:00:00 00:00:00", "0000-00-00T00:00:00"})
    EXPECT_EQ(clock_in(blank), std::nullopt) << blank;
}

TEST(ClockIn, RefusesWhatIsNoDate) {
  for (const char* odd : {"21 January 2019", "2019:13:21 05:12:16", "2019:01:21 25:12:16",
                          "2019:01:21", "2019:02:30 05:12:16"})
    EXPECT_THROW(clock_in(odd), algebra::Error) << odd;
}

}  // namespace
}  // namespace coppermoon::uses
