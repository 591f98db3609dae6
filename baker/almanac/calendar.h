// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"

namespace coppermoon::almanac {

/// Converts a Gregorian date to the given calendar: "1504-03-11" is "1504-03-01" in the Julian calendar.
///
/// Given   date  such as "2018-07-27" or "-0584-05-22"
/// Source  Meeus (1998), Astronomical Algorithms, chapter 7: from Julian days to calendar dates
std::string date_in(Calendar calendar, const std::string& date);

/// A moment in UTC in the format of ISO 8601, but with its date in the given calendar. ISO 8601 itself is Gregorian.
std::string utc_text(const Instant& instant, Calendar calendar, int decimals = 0);

/// The UTC date of a moment, such as "2018-07-27", and its time of day to the second, such as "20:21:45".
std::string date_text(const Instant& instant, Calendar calendar = Calendar::gregorian);
std::string time_of_day_text(const Instant& instant);

/// Rounds a moment to the nearest full minute: 20:21:45 becomes 20:22.
Instant to_the_minute(const Instant& instant);

}  // namespace coppermoon::almanac
