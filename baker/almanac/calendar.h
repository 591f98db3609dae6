// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"

namespace coppermoon::almanac {

/// Date in a calendar, converted from a Gregorian date: "1504-03-11" is "1504-03-01" in the Julian calendar.
///
/// Given   date  "2018-07-27", "-0584-05-22"
/// Source  Meeus (1998), Astronomical Algorithms, chapter 7: the Julian date of a Julian day
std::string date_in(Calendar calendar, const std::string& date);

/// Text as by utc_text, with its date in a calendar; ISO 8601 itself is Gregorian.
std::string utc_text(const Instant& instant, Calendar calendar, int decimals = 0);

/// Date and time of day of utc_text, to the second: "2018-07-27" and "20:21:45".
std::string date_text(const Instant& instant, Calendar calendar = Calendar::gregorian);
std::string time_of_day_text(const Instant& instant);

/// The nearest full minute: of 20:21:45 it is 20:22.
Instant to_the_minute(const Instant& instant);

}  // namespace coppermoon::almanac
