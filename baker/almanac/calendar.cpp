// SPDX-License-Identifier: MIT
#include "almanac/calendar.h"

#include <erfa.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace coppermoon::almanac {
namespace {

std::string in_julian(int year, int month, int day) {
  double midnight_1 = 0, midnight_2 = 0;
  eraCal2jd(year, month, day, &midnight_1, &midnight_2);
  const int b = static_cast<int>(std::lround(midnight_1 + midnight_2 + 0.5)) + 1524,
            c = static_cast<int>((b - 122.1) / 365.25), d = static_cast<int>(365.25 * c),
            e = static_cast<int>((b - d) / 30.6001);
  const int julian_month = e < 14 ? e - 1 : e - 13,
            julian_year = julian_month > 2 ? c - 4716 : c - 4715;
  return fmt::format("{}{:04}-{:02}-{:02}", julian_year < 0 ? "-" : "", std::abs(julian_year),
                     julian_month, b - d - static_cast<int>(30.6001 * e));
}

}  // namespace

std::string date_in(Calendar calendar, const std::string& date) {
  if (calendar == Calendar::gregorian) return date;
  const std::size_t sign = date.starts_with('-');
  const int year = std::stoi(date.substr(sign, 4));
  return in_julian(sign == 1 ? -year : year, std::stoi(date.substr(sign + 5, 2)),
                   std::stoi(date.substr(sign + 8, 2)));
}

std::string utc_text(const Instant& instant, Calendar calendar, int decimals) {
  const auto text = utc_text(instant, decimals);
  const auto date_ends = text.find('T');
  return date_in(calendar, text.substr(0, date_ends)) + text.substr(date_ends);
}

std::string date_text(const Instant& instant, Calendar calendar) {
  const auto text = utc_text(instant, calendar);
  return text.substr(0, text.find('T'));
}

std::string time_of_day_text(const Instant& instant) {
  const auto text = utc_text(instant);
  return text.substr(text.find('T') + 1, 8);
}

Instant to_the_minute(const Instant& instant) {
  const auto text = utc_text(later(instant, 30));
  return instant_from_utc(text.substr(0, text.rfind(':')) + "Z");
}

}  // namespace coppermoon::almanac
