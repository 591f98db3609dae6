// SPDX-License-Identifier: MIT
#include "uses/picture/photo_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algebra/error.h"
#include "baker/texture/scratch_folder.h"
#include "support/within.h"
#include "texture/write_image.h"

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

class Settings : public ScratchFolder {
 protected:
  /// Those of a file whose header says so.
  CameraSettings of(texture::Attributes header) const {
    const auto file = in_folder("a.exr");
    texture::write_exr(file, texture::Image(4, 4, {"R", "G", "B"}), header);
    return settings_of(file.string());
  }
};

TEST_F(Settings, OfACameraAreThoseThatItUses) {
  const auto found = of({{"Make", "Canon"},
                         {"Model", "Canon EOS 6D"},
                         {"Exif:ExposureTime", 1.F / 30},
                         {"Exif:FNumber", 5.6F},
                         {"Exif:PhotographicSensitivity", 6400.F}});
  EXPECT_WITHIN_RELATIVE(found.time_s.value(), 1. / 32, 1e-5, "headers are read as six digits");
  EXPECT_WITHIN_RELATIVE(found.f_number.value(), 5.656854, 1e-5, "headers are read as six digits");
  EXPECT_WITHIN_RELATIVE(found.iso.value(), 6400, 1e-5, "headers are read as six digits");
}

TEST_F(Settings, TakeTheTimeFromTheApexValue) {
  const auto time_s = [&](float shown_s, double apex) {
    return of({{"Make", "Canon"},
               {"Exif:ExposureTime", shown_s},
               {"Exif:ShutterSpeedValue", static_cast<float>(apex)}})
        .time_s.value();
  };
  const auto is = [](double found, double real) {
    EXPECT_WITHIN_RELATIVE(found, real, 1e-5, "headers are read as six digits");
  };
  is(time_s(1.F / 30, 5), 1. / 32);
  is(time_s(1.F / 30, std::log2(30.)), 1. / 32);     // as computed from the time shown
  is(time_s(1.F / 40, 5.375), std::exp2(-16. / 3));  // as Canon writes a third
  is(time_s(1.F / 20, 4.5), std::exp2(-4.5));        // half a stop, not a third
  is(time_s(0.5F, 0), 0.5);                          // absent or wrong
}

TEST_F(Settings, OfOurOwnFilesStayAsTheyWereAskedFor) {
  for (const char* make : {"coppermoon", ""})
    EXPECT_WITHIN_RELATIVE(of({{"Make", make}, {"expTime", 1.F / 30}}).time_s.value(), 1. / 30,
                           1e-5, "headers are read as six digits");
}

}  // namespace
}  // namespace coppermoon::uses
