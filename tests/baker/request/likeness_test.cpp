// SPDX-License-Identifier: MIT
#include "request/likeness.h"

#include "support/testing.h"

namespace coppermoon::request::likeness_test {

TEST(Likeness, CountsLettersToInsertDropOrChange) {
  for (const auto& [a, b, letters] : {std::tuple{"ozone-du", "ozone-du", 0U},
                                      {"ozon-du", "ozone-du", 1U},
                                      {"jsn", "json", 1U},
                                      {"kitten", "sitting", 3U},
                                      {"", "seed", 4U},
                                      {"flaw", "lawn", 2U}}) {
    EXPECT_EQ(letters_apart(a, b), letters) << a << ", " << b;
    EXPECT_EQ(letters_apart(b, a), letters) << "either way";
  }
}

TEST(Likeness, FindsTheNearestOfKnownWords) {
  const std::vector<std::string> known{"rays", "seed", "ozone-du", "cloud-cover"};
  EXPECT_EQ(nearest("ozone", known), "ozone-du");
  EXPECT_EQ(nearest("sead", known), "seed");
  EXPECT_EQ(nearest(std::string(1'000'000, 'n'), known), "ozone-du") << "the only n, in no time";
}

}  // namespace coppermoon::request::likeness_test
