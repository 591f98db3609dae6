// SPDX-License-Identifier: MIT
#include "uses/film/film_sheet.h"

#include "support/testing.h"

namespace coppermoon::uses::film_sheet_test {

/// A moment of the eclipse of 2018 July 27: seconds from a contact on.
struct FromContact {
  const char* contact;
  double seconds = 0;
};

Moments moments_between(const FromContact& from, const FromContact& to, std::size_t count) {
  const auto eclipse = eclipse::nearest_eclipse(almanac::instant_from_utc("2018-07-27"),
                                                eclipse::ShadowConvention::danjon);
  const auto contacts = contacts_of(eclipse);
  const auto moment = [&](const FromContact& from_contact) {
    const auto found = std::ranges::find(contacts, from_contact.contact,
                                         &std::pair<std::string, almanac::Instant>::first);
    return almanac::later(found->second, from_contact.seconds);
  };
  return moments_of({.eclipse = eclipse, .from = moment(from), .to = moment(to), .frames = count});
}

std::vector<std::size_t> all_of(const Moments& moments) {
  std::vector<std::size_t> frames(moments.frames.size());
  std::iota(frames.begin(), frames.end(), std::size_t{1});
  return frames;
}

/// Whether a frame is at a contact: it has the contact's name, and the seconds from it.
bool is_at(const SheetFrame& frame, const std::string& contact) {
  return frame.at_contact && frame.moment.substr(0, frame.moment.find_first_of("+-")) == contact;
}

TEST(FramesOfSheet, HoldTheNearestToEachContact) {
  const auto moments = moments_between({"P1"}, {"P4"}, 1000);
  const auto sheet = frames_of_sheet(moments, all_of(moments));
  const double step = almanac::seconds_between(moments.frames[0], moments.frames[1]);
  for (const auto& [name, when] : contacts_of(moments.eclipse)) {
    const double place = almanac::seconds_between(moments.frames[0], when) / step;
    const auto expected = static_cast<std::size_t>(std::lround(place)) + 1;
    const auto found = std::ranges::find_if(
        sheet, [&, contact = name](const SheetFrame& frame) { return is_at(frame, contact); });
    ASSERT_NE(found, sheet.end()) << name;
    EXPECT_EQ(found->frame, expected) << name;
  }
}

TEST(FramesOfSheet, AtAContactSayHowFarFromIt) {
  // frames 94 s apart, as 240 from P1 to P4 are, of which the nearest to U2 is 44 s after it
  const auto moments = moments_between({"U2", 44 - 2 * 94}, {"U2", 44 + 2 * 94}, 5);
  const auto sheet = frames_of_sheet(moments, all_of(moments));
  ASSERT_EQ(sheet.size(), 5);
  EXPECT_EQ(sheet[2].moment, "U2+44s");
  EXPECT_TRUE(sheet[2].at_contact);
  EXPECT_EQ(sheet[1].moment, "U2-50s");
  EXPECT_FALSE(sheet[1].at_contact);
}

TEST(FramesOfSheet, HaveTheNumbersOfTheFilm) {
  auto moments = moments_between({"U1", -30}, {"U1", 30}, 3);
  moments.first_frame = 1001;
  const auto sheet = frames_of_sheet(moments, {1001, 1002, 1003});
  ASSERT_EQ(sheet.size(), 3);
  EXPECT_EQ(sheet[1].frame, 1002);
  EXPECT_EQ(sheet[1].moment, "U1");
}

TEST(FramesOfSheet, AreSomeFortyOfALongFilmInOrder) {
  const auto moments = moments_between({"P1"}, {"P4"}, 1000);
  const auto sheet = frames_of_sheet(moments, all_of(moments));
  EXPECT_GE(sheet.size(), 40);
  EXPECT_LE(sheet.size(), 47);
  EXPECT_EQ(sheet.front().frame, 1);
  EXPECT_EQ(sheet.back().frame, 1000);
  for (std::size_t i = 1; i < sheet.size(); ++i) {
    EXPECT_GT(sheet[i].frame, sheet[i - 1].frame);
    EXPECT_LE(sheet[i].frame - sheet[i - 1].frame, 26) << "1000 / 39, rounded up";
  }
}

TEST(FramesOfSheet, AreAllOfAShortFilm) {
  const auto moments = moments_between({"P1"}, {"P4"}, 12);
  EXPECT_EQ(frames_of_sheet(moments, all_of(moments)).size(), 12);
}

TEST(FramesOfSheet, FarFromAContactSayHowFar) {
  const auto sheet = frames_of_sheet(moments_between({"U2", -12 * 60}, {"U2", 12 * 60}, 2), {1, 2});
  EXPECT_EQ(sheet.front().moment, "U2-12min");
  EXPECT_EQ(sheet.back().moment, "U2+12min");
  for (const auto& frame : sheet) EXPECT_FALSE(frame.at_contact);
}

TEST(FramesOfSheet, AreNamedAfterNoContactBeyondTheFilm) {
  const auto moments = moments_between({"U2", 10 * 60}, {"greatest"}, 20);
  const auto sheet = frames_of_sheet(moments, all_of(moments));
  EXPECT_EQ(sheet.front().moment, "U2+10min");
  EXPECT_FALSE(sheet.front().at_contact);
  EXPECT_EQ(std::ranges::count(sheet, true, &SheetFrame::at_contact), 1);
  EXPECT_EQ(sheet.back().moment, "greatest");
}

TEST(FramesOfSheet, TellTheWayFromTheNearestContact) {
  const auto moments = moments_between({"U1", -30}, {"U1", 30}, 3);
  const auto sheet = frames_of_sheet(moments, all_of(moments));
  ASSERT_EQ(sheet.size(), 3);
  EXPECT_EQ(sheet[0].moment, "U1-30s");
  EXPECT_EQ(sheet[1].moment, "U1");
  EXPECT_EQ(sheet[2].moment, "U1+30s");
}

TEST(FramesOfSheet, OfARangeAreOfItAlone) {
  const auto moments = moments_between({"P1"}, {"P4"}, 100);
  const auto sheet = frames_of_sheet(moments, {10, 20, 30});
  ASSERT_EQ(sheet.size(), 3);
  EXPECT_EQ(sheet[1].frame, 20);
}

TEST(FramesOfSheet, OfASingleMomentIsNamedAfterIt) {
  const auto moments = moments_between({"U3"}, {"U3"}, 1);
  const auto sheet = frames_of_sheet(moments, {1});
  ASSERT_EQ(sheet.size(), 1);
  EXPECT_EQ(sheet[0].moment, "U3");
}

}  // namespace coppermoon::uses::film_sheet_test
