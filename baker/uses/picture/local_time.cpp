// SPDX-License-Identifier: MIT
#include "uses/picture/local_time.h"

#include <absl/time/civil_time.h>
#include <absl/time/time.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "algebra/error.h"
#include "almanac/gazetteer.h"

namespace coppermoon::uses {

namespace {

constexpr double city_clocks_km = 300;  ///< a city's time zone applies up to this distance

/// Civil date and time of an instant in UTC, to the second, without leap seconds.
absl::CivilSecond civil_time(const almanac::Instant& when) {
  const auto text = almanac::utc_text(when);
  const std::size_t sign = text.starts_with('-');
  const auto part = [&](std::size_t from, std::size_t count) {
    return std::stoi(text.substr(sign + from, count));
  };
  return absl::CivilSecond((sign ? -1 : 1) * part(0, 4), part(5, 2), part(8, 2), part(11, 2),
                           part(14, 2), part(17, 2));
}

std::string date_text(const absl::CivilSecond& time) {
  return fmt::format("{}{:04}-{:02}-{:02}", time.year() < 0 ? "-" : "", std::abs(time.year()),
                     time.month(), time.day());
}

std::string clock_text(const absl::CivilSecond& time) {
  return fmt::format("{:02}:{:02}:{:02}", time.hour(), time.minute(), time.second());
}

/// Whether a string has only characters that occur in IANA's zone names. Any other string could be a path to a file.
bool is_plain(const std::string& name) {
  return std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-' || c == '+' || c == '/';
  });
}

absl::TimeZone zone_named(const std::string& zone) {
  absl::TimeZone found;
  if (zone.starts_with('+') || zone.starts_with('-')) {
    const auto there = almanac::instant_from_utc("2000-01-01T00:00" + zone),
               here = almanac::instant_from_utc("2000-01-01T00:00");
    return absl::FixedTimeZone(
        static_cast<int>(std::lround(almanac::seconds_between(there, here))));
  }
  if (zone.empty() || zone.starts_with('/') || !is_plain(zone) || !absl::LoadTimeZone(zone, &found))
    throw algebra::Error(
        fmt::format("time zone = {}: not in this system's zoneinfo (tzdata), allowed a name of the "
                    "IANA's data, as Africa/Nairobi, or an offset, as +03:00",
                    zone));
  return found;
}

double kilometres_between(const almanac::Observer& observer, const almanac::City& city) {
  return algebra::in_kilometres(almanac::distance_between(observer, city.place));
}

/// Offset from UTC that follows from the longitude, in whole hours; positive in the east.
int hours_by_longitude(const almanac::Observer& observer) {
  const double east_deg = std::remainder(algebra::in_degrees(observer.longitude), 360);
  return static_cast<int>(std::lround(east_deg / 15));
}

}  // namespace

LocalTime local_time(const almanac::Instant& when, const std::string& zone) {
  const auto utc = absl::FromCivil(civil_time(when), absl::UTCTimeZone());
  const auto local = zone_named(zone).At(utc);
  return {date_text(local.cs), clock_text(local.cs), local.zone_abbr};
}

almanac::Instant instant_of_local(const std::string& local, const std::string& zone,
                                  almanac::Calendar calendar) {
  const auto read = almanac::instant_from_utc(local, calendar);
  const auto decimals_s =
      almanac::seconds_between(almanac::instant_from_utc(almanac::utc_text(read)), read);
  const auto found = zone_named(zone).At(civil_time(read));
  const bool skipped = found.kind == absl::TimeZone::TimeInfo::SKIPPED;
  const auto utc = absl::ToCivilSecond(skipped ? found.trans : found.pre, absl::UTCTimeZone());
  return almanac::later(almanac::instant_from_utc(date_text(utc) + "T" + clock_text(utc) + "Z"),
                        decimals_s);
}

std::string time_zone_of(const almanac::Observer& observer) {
  const auto city = almanac::nearest_city(observer);
  if (kilometres_between(observer, city) <= city_clocks_km) return city.time_zone;
  return fmt::format("Etc/GMT{:+}", -hours_by_longitude(observer));  // in POSIX, west is positive
}

std::string zone_or_utc(const almanac::Observer& observer) {
  auto zone = time_zone_of(observer);
  absl::TimeZone found;
  return absl::LoadTimeZone(zone, &found) ? zone : "+00:00";
}

std::string whose_clocks(const almanac::Observer& observer) {
  const auto city = almanac::nearest_city(observer);
  const double km = kilometres_between(observer, city);
  if (km <= city_clocks_km)
    return fmt::format(
        "Local times are those of {} ({}), the nearest city that is known, {:.0f} km away.",
        city.name, city.time_zone, km);
  return fmt::format(
      "Local times are by the longitude, UTC{:+}: the nearest city that is known, {}, is {:.0f} km "
      "away.",
      hours_by_longitude(observer), city.name, km);
}

}  // namespace coppermoon::uses
