// SPDX-License-Identifier: MIT
#include "almanac/instant.h"

#include <erfa.h>
#include <erfam.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <regex>
#include <string>

#include "algebra/error.h"
#include "algebra/number.h"

namespace coppermoon::almanac {
namespace {

struct CivilTime {
  int year = 0, month = 1, day = 1, hour = 0, minute = 0;
  double second = 0;
  int minutes_east = 0;  ///< offset from UTC
};

/// Whether a time of day is valid in some time zone. Second 60 may be a leap second; 24:00 is the end of the day.
bool is_time_of_day(const CivilTime& c) {
  const bool ends_day = c.hour == 24 && c.minute == 0 && c.second == 0;
  return (c.hour < 24 || ends_day) && c.minute < 60 && c.second < 61;
}

/// Reads date, time of day and offset from UTC in an ISO 8601 text; nullopt if the text is not valid, or the year is
/// outside −1999 to 3000.
std::optional<CivilTime> civil_time(std::string_view text) {
  static const std::regex iso_8601(
      R"(([+-]?)(\d{4})(-?)(\d\d)\3(\d\d))"                   // date, with or without hyphens
      R"((?:[Tt ](\d\d)(:?)(\d\d)(?:\7(\d\d(?:\.\d+)?))?)?)"  // time of day
      R"((?:([Zz])|([+-])(\d\d)(?::?(\d\d))?)?)");            // offset from UTC
  constexpr std::size_t longest = 64;
  std::cmatch part;
  if (text.size() > longest ||
      !std::regex_match(text.data(), text.data() + text.size(), part, iso_8601))
    return std::nullopt;
  const auto number = [&](std::size_t group) {
    return part[group].matched ? std::stoi(part[group].str()) : 0;
  };
  const bool timed = part[6].matched, offset = part[11].matched;
  CivilTime c{part[1] == "-" ? -number(2) : number(2),
              number(4),
              number(5),
              number(6),
              number(8),
              algebra::number_in(part[9].str()).value_or(0),
              (part[11] == "-" ? -1 : 1) * (60 * number(12) + number(13))};
  const bool sound = c.year >= -1999 && c.year <= 3000 && is_time_of_day(c) && (timed || !offset) &&
                     number(12) <= 18 && number(13) < 60;
  return sound ? std::optional(c) : std::nullopt;
}

/// Converts a moment to UTC and keeps second 60, which may be a leap second; nullopt if the date does not exist.
std::optional<CivilTime> in_utc(CivilTime c) {
  constexpr int day_min = 24 * 60;
  const int minutes = 60 * c.hour + c.minute - c.minutes_east;
  const int days = (minutes + 2 * day_min) / day_min - 2;  // rounded down, even if negative
  double day = 0, midnight = 0, fraction = 0;
  if (eraCal2jd(c.year, c.month, c.day, &day, &midnight) != 0) return std::nullopt;
  eraJd2cal(day, midnight + days, &c.year, &c.month, &c.day, &fraction);
  c.hour = (minutes - days * day_min) / 60;
  c.minute = (minutes - days * day_min) % 60;
  c.minutes_east = 0;
  return c;
}

/// Converts a date from the Julian to the Gregorian calendar; nullopt if the date does not exist.
///
/// Source  Meeus (1998), Astronomical Algorithms, chapter 7: from calendar dates to Julian days
std::optional<CivilTime> in_gregorian(CivilTime c) {
  constexpr int days_in[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (c.month < 1 || c.month > 12) return std::nullopt;
  const bool leap_day = c.month == 2 && c.year % 4 == 0;
  if (c.day < 1 || c.day > days_in[c.month - 1] + leap_day) return std::nullopt;
  const int year = c.month > 2 ? c.year : c.year - 1;
  const int month = c.month > 2 ? c.month : c.month + 12;
  const double noon_before =
      std::floor(365.25 * (year + 4716)) + std::floor(30.6001 * (month + 1)) + c.day - 1524;
  double fraction = 0;
  eraJd2cal(noon_before, -0.5, &c.year, &c.month, &c.day, &fraction);
  return c;
}

Instant normalised(double day, double fraction) {
  const double whole = std::floor(fraction);
  return {day + whole, fraction - whole};
}

enum class Scale { utc, ut1 };  // UTC if ERFA has leap seconds for the year, otherwise UT1

constexpr int dubious_year =
    1;  // ERFA's status for dates after its table of leap seconds, including the end of the table's last day

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

Instant instant_from_utc(std::string_view text, Calendar calendar) {
  auto c = civil_time(text);
  if (c && calendar == Calendar::julian) c = in_gregorian(*c);
  if (c) c = in_utc(*c);
  double day = 0, fraction = 0;
  const int status = !c ? -1
                        : eraDtf2d(name(scale_in(c->year)), c->year, c->month, c->day, c->hour,
                                   c->minute, c->second, &day, &fraction);
  if (status != 0 && status != dubious_year)
    throw algebra::Error(
        fmt::format("date \"{}\": allowed is an ISO 8601 date of the years -1999 to 3000, such as "
                    "2026-03-03, 2026-03-03T11:33:43Z or 2026-03-03T13:33:43+02:00",
                    text));
  return scale_in(c->year) == Scale::utc ? from_utc(day, fraction) : from_ut1(day, fraction);
}

std::string utc_text(const Instant& instant, int decimals) {
  algebra::require_within("decimals of a second", decimals, 0, 9);
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
