// SPDX-License-Identifier: MIT
#include "almanac/instant.h"

#include <erfa.h>
#include <erfam.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "algebra/error.h"

namespace coppermoon::almanac {
namespace {

struct Calendar {
  int year = 0, month = 1, day = 1, hour = 0, minute = 0;
  double second = 0;
};

/// Takes exactly `count` digits off the front of the text.
std::optional<int> take_digits(std::string_view& text, int count) {
  int value = 0;
  for (int i = 0; i < count; ++i) {
    if (text.empty() || text.front() < '0' || text.front() > '9') return std::nullopt;
    value = 10 * value + (text.front() - '0');
    text.remove_prefix(1);
  }
  return value;
}

bool take(std::string_view& text, char letter) {
  if (!text.starts_with(letter)) return false;
  text.remove_prefix(1);
  return true;
}

bool take_number(std::string_view& text, int count, int& value) {
  const auto number = take_digits(text, count);
  value = number.value_or(0);
  return number.has_value();
}

bool take_date(std::string_view& text, Calendar& c) {
  const bool before_christ = take(text, '-');
  if (!before_christ) take(text, '+');
  const bool read = take_number(text, 4, c.year) && take(text, '-') &&
                    take_number(text, 2, c.month) && take(text, '-') && take_number(text, 2, c.day);
  if (before_christ) c.year = -c.year;
  return read;
}

bool take_second(std::string_view& text, Calendar& c) {
  int whole = 0;
  if (!take_number(text, 2, whole)) return false;
  c.second = whole;
  if (!take(text, '.')) return true;
  double unit = 0.1;
  auto digit = take_digits(text, 1);
  if (!digit) return false;
  for (; digit; digit = take_digits(text, 1), unit /= 10) c.second += unit * *digit;
  return true;
}

bool take_time(std::string_view& text, Calendar& c) {
  if (!take_number(text, 2, c.hour) || !take(text, ':') || !take_number(text, 2, c.minute))
    return false;
  return !take(text, ':') || take_second(text, c);
}

std::optional<Calendar> calendar_of(std::string_view text) {
  Calendar c;
  if (!take_date(text, c) || c.year < -1999 || c.year > 3000) return std::nullopt;
  if (take(text, 'T') && !take_time(text, c)) return std::nullopt;
  take(text, 'Z');
  if (!text.empty()) return std::nullopt;
  return c;
}

Instant normalised(double day, double fraction) {
  const double whole = std::floor(fraction);
  return {day + whole, fraction - whole};
}

enum class Scale { utc, ut1 };  // UTC proper while ERFA has leap seconds, otherwise read as UT1

constexpr int dubious_year =
    1;  // ERFA's word for a day after its leap seconds: here the last one's end

const char* name(Scale scale) { return scale == Scale::utc ? "UTC" : "UT1"; }

Scale scale_in(int year) {
  double tai_minus_utc_s = 0;
  const bool tabulated = year >= 1972 && eraDat(year, 1, 1, 0, &tai_minus_utc_s) == 0;
  return tabulated ? Scale::utc : Scale::ut1;
}

Instant from_utc(double day, double fraction) {
  double tai1 = 0, tai2 = 0, tt1 = 0, tt2 = 0;
  eraUtctai(day, fraction, &tai1, &tai2);
  eraTaitt(tai1, tai2, &tt1, &tt2);
  return normalised(tt1, tt2);
}

Instant from_ut1(double day, double fraction) {
  Instant tt = normalised(day, fraction);
  for (int round = 0; round < 4; ++round)
    tt = normalised(day, fraction + delta_t_s(tt) / ERFA_DAYSEC);
  return tt;
}

}  // namespace

Instant instant_from_utc(std::string_view text) {
  const auto c = calendar_of(text);
  double day = 0, fraction = 0;
  const int status = !c ? -1
                        : eraDtf2d(name(scale_in(c->year)), c->year, c->month, c->day, c->hour,
                                   c->minute, c->second, &day, &fraction);
  if (status != 0 && status != dubious_year)
    throw algebra::Error(
        fmt::format("date \"{}\" is no ISO 8601 UTC date of the years -1999 to "
                    "3000, such as 2008-02-21T03:26:05Z",
                    text));
  return scale_in(c->year) == Scale::utc ? from_utc(day, fraction) : from_ut1(day, fraction);
}

std::string utc_text(const Instant& instant, int decimals) {
  algebra::require_within("decimals of a second", decimals, 0, 3);
  double day = instant.tt_day, fraction = instant.tt_fraction - delta_t_s(instant) / ERFA_DAYSEC;
  int year = 0, month = 0, day_of_month = 0;
  double rest = 0;
  eraJd2cal(day, fraction, &year, &month, &day_of_month, &rest);
  const Scale scale = scale_in(year);
  if (scale == Scale::utc) {
    double tai1 = 0, tai2 = 0;
    eraTttai(instant.tt_day, instant.tt_fraction, &tai1, &tai2);
    eraTaiutc(tai1, tai2, &day, &fraction);
  }
  int clock[4] = {};
  eraD2dtf(name(scale), decimals, day, fraction, &year, &month, &day_of_month, clock);
  const auto decimal_part = decimals == 0 ? "" : fmt::format(".{:0{}}", clock[3], decimals);
  return fmt::format("{}{:04}-{:02}-{:02}T{:02}:{:02}:{:02}{}Z", year < 0 ? "-" : "",
                     std::abs(year), month, day_of_month, clock[0], clock[1], clock[2],
                     decimal_part);
}

double year_of(const Instant& instant) {
  constexpr double new_year_2000 = 2451544.5, tropical_year = 365.2422;
  return 2000 + (instant.tt_day - new_year_2000 + instant.tt_fraction) / tropical_year;
}

Instant later(const Instant& instant, double seconds) {
  return normalised(instant.tt_day, instant.tt_fraction + seconds / ERFA_DAYSEC);
}

double seconds_between(const Instant& from, const Instant& to) {
  return ((to.tt_day - from.tt_day) + (to.tt_fraction - from.tt_fraction)) * ERFA_DAYSEC;
}

}  // namespace coppermoon::almanac
