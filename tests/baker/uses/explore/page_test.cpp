// SPDX-License-Identifier: MIT
#include "support/testing.h"
#include "uses/explore/exploration.h"

namespace coppermoon::uses::page_test {

TEST(CalendarPage, RoundsTimesToTheMinute) {
  eclipse::Eclipse eclipse{};
  const auto page_of = [&](const char* greatest) {
    eclipse.greatest = almanac::instant_from_utc(greatest);
    return calendar_page({eclipse}, {"a.html"});
  };
  EXPECT_SAYS(page_of("2018-07-27T20:21:45Z"), ">2018-07-27</a></td><td>20:22</td>");
  EXPECT_SAYS(page_of("2018-12-31T23:59:45Z"), ">2019-01-01</a></td><td>00:00</td>");
}

}  // namespace coppermoon::uses::page_test
