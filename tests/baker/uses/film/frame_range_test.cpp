// SPDX-License-Identifier: MIT
#include "uses/film/film_times.h"

#include "support/testing.h"

namespace coppermoon::uses::frame_range_test {

using Frames = std::vector<std::size_t>;

TEST(FrameRange, IsReadAsTheTradeWritesIt) {
  EXPECT_EQ(frames_in("", 3), (Frames{1, 2, 3}));
  EXPECT_EQ(frames_in("2-4", 9), (Frames{2, 3, 4}));
  EXPECT_EQ(frames_in("1-9x3", 9), (Frames{1, 4, 7}));
  EXPECT_EQ(frames_in("7,9,2-3", 9), (Frames{7, 9, 2, 3})) << "in the order written";
  EXPECT_EQ(frames_in("3,1-4", 9), (Frames{3, 1, 2, 4})) << "each once";
  EXPECT_EQ(frames_in("", 3, 1001), (Frames{1001, 1002, 1003}));
  EXPECT_EQ(frames_in("1003,1001-1002", 3, 1001), (Frames{1003, 1001, 1002}));
  EXPECT_EQ(frames_in("0", 3, 0), (Frames{0}));
}

TEST(FrameRange, BeyondTheFilmOrOfOtherWritingIsRefused) {
  for (const char* text : {"0-3", "1-10", "4-2", "1-9x0", "1-", "-3", "a", "1 - 3", "+1", "1..3",
                           "1-9x", "99999999999999999999", ","})
    EXPECT_THROW(frames_in(text, 9), algebra::Error) << text;
  for (const char* text : {"1", "1000", "1001-1004"})
    EXPECT_THROW(frames_in(text, 3, 1001), algebra::Error) << text;
}

TEST(Shards, TakeEveryFrameOnce) {
  const auto all = frames_in("", 100);
  for (const std::size_t parts : {1, 3, 8, 100, 130}) {
    Frames together;
    for (std::size_t part = 1; part <= parts; ++part) {
      const auto mine = part_of(all, {part, parts});
      EXPECT_LE(mine.size(), (all.size() + parts - 1) / parts) << "none has more than its share";
      together.insert(together.end(), mine.begin(), mine.end());
    }
    std::ranges::sort(together);
    EXPECT_EQ(together, all);
  }
}

TEST(Shards, OfOtherWritingAreRefused) {
  EXPECT_EQ(shard_from("2/8").part, 2U);
  EXPECT_EQ(shard_from("2/8").parts, 8U);
  for (const char* text : {"0/8", "9/8", "1", "1/", "/8", "a/b", "1/8/9", "-1/8", "1/100001"})
    EXPECT_THROW(shard_from(text), algebra::Error) << text;
}

}  // namespace coppermoon::uses::frame_range_test
