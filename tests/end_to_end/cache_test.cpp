// SPDX-License-Identifier: MIT
// Kept textures: listed, and removed when they are too many.
#include <chrono>
#include <nlohmann/json.hpp>

#include "support/program.h"

namespace coppermoon::end_to_end::cache_test {

using nlohmann::json;
using std::chrono::hours;

class Cache : public ProgramTest {
 protected:
  Outcome in_cache(const Words& words, const std::string& limit = "") const {
    return run(Words{"env", "COPPERMOON_CACHE=" + here("kept").string(),
                     "COPPERMOON_CACHE_LIMIT=" + limit, COPPERMOON_PROGRAM} +
               words);
  }

  /// Bakes a texture of some width into the cache.
  std::string baked(int width, const std::string& limit = "") const {
    const auto outcome = in_cache(words_of("bake 2018-07-27T19:40:17Z --unshadowed --albedo-map "
                                           "built-in --texture-width {} --cache {}",
                                           width, here("kept")),
                                  limit);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return outcome.out.substr(0, outcome.out.find('\n'));
  }

  static void age(const std::string& file, hours by) {
    std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) - by);
  }

  json listed() const { return json::parse(in_cache("cache --json").out); }
  static bool is_there(const std::string& file) { return std::filesystem::exists(file); }
};

TEST_F(Cache, IsListedWithWhatEachTextureIs) {
  EXPECT_EQ(listed()["textures"], json::array()) << "no folder is no error";
  const auto older = baked(64), newer = baked(128);
  age(older, hours(72));
  file("kept/0123456789abcdef.tx.txt", "somebody else's");
  file("kept/moon.tx", "somebody else's");
  const auto said = listed();
  ASSERT_EQ(said["textures"].size(), 2U);
  EXPECT_EQ(said["textures"][0]["file"], newer) << "that used last stands first";
  EXPECT_EQ(said["textures"][1]["instant"], "2018-07-27T19:40:17Z");
  EXPECT_NEAR(said["textures"][1]["days_since_use"].get<double>(), 3, 0.1);
  EXPECT_EQ(said["bytes"].get<double>(), static_cast<double>(std::filesystem::file_size(older) +
                                                             std::filesystem::file_size(newer)));
  const auto words = in_cache({"cache"}).out;
  EXPECT_SAYS(words, "2018-07-27T19:40:17Z");
  EXPECT_SAYS(words, "2 textures, ");
  EXPECT_SAYS(words, "limit 20 GB");
}

TEST_F(Cache, IsCleanedOfWhatWasUsedLongestAgo) {
  const auto first = baked(64), second = baked(128), third = baked(256);
  age(first, hours(2));
  age(second, hours(1));
  baked(64);  // used again
  file("kept/moon.tx", "somebody else's");
  const auto bytes =
      static_cast<double>(std::filesystem::file_size(first) + std::filesystem::file_size(third));
  const auto outcome =
      in_cache(words_of("cache --clean --limit {}", std::to_string(bytes / 1e9 + 1e-6)));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(is_there(first) && is_there(third));
  EXPECT_FALSE(is_there(second)) << outcome.out;
  EXPECT_SAYS(outcome.out, "1 textures removed");
  expect_done(in_cache("cache --clean --limit 0"));
  EXPECT_FALSE(is_there(first) || is_there(third));
  EXPECT_EQ(text_of(here("kept/moon.tx")), "somebody else's");
}

TEST_F(Cache, HasALimitThatLeavesWhatWasUsedToday) {
  const auto old = baked(64), recent = baked(128);
  age(old, hours(48));
  age(recent, hours(12));
  const auto made = baked(256, "1e-6");
  EXPECT_FALSE(is_there(old));
  EXPECT_TRUE(is_there(recent)) << "a scene that is open may show it";
  EXPECT_TRUE(is_there(made));
}

TEST_F(Cache, OfAFolderThatTheUserNamesHasNoLimit) {
  const auto old = baked(64);
  age(old, hours(48));
  const auto outcome =
      run(words_of("env COPPERMOON_CACHE_LIMIT=0 {} bake 2018-07-27T19:40:17Z --unshadowed "
                   "--albedo-map built-in --texture-width 128 --cache {}",
                   COPPERMOON_PROGRAM, here("kept")));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(is_there(old)) << "a scene may rely on it";
}

TEST_F(Cache, RefusesWhatItCannotDo) {
  EXPECT_EQ(in_cache("cache --limit 1").status, 2);
  EXPECT_EQ(in_cache("cache --clean --list").status, 2);
  EXPECT_EQ(in_cache("cache --clean --limit -1").err,
            "coppermoon: limit [GB] = -1, allowed 0 to 1e+06\n");
  EXPECT_EQ(in_cache({"cache"}, "much").err,
            "coppermoon: COPPERMOON_CACHE_LIMIT [GB] = much, allowed a number of 0 or more\n");
}

}  // namespace coppermoon::end_to_end::cache_test
