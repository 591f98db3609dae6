// SPDX-License-Identifier: MIT
#include "uses/night/local_time.h"

#include <date/tz.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <exception>

#include "algebra/error.h"

namespace coppermoon::uses {

namespace {

/// Days and seconds that a text as "2018-07-27T23:21:45" tells, on whatever clock.
std::chrono::seconds told_by(const std::string& text) {
  const auto part = [&](std::size_t from, std::size_t count) {
    return std::stoi(text.substr(from, count));
  };
  const auto day = date::year(part(0, 4)) / part(5, 2) / part(8, 2);
  return date::sys_days(day).time_since_epoch() + std::chrono::hours(part(11, 2)) +
         std::chrono::minutes(part(14, 2)) + std::chrono::seconds(part(17, 2));
}

algebra::Error no_such_zone(const std::string& zone, const std::exception& error) {
  return algebra::Error(
      fmt::format("time zone {}: not in this system's zoneinfo ({})", zone, error.what()));
}

}  // namespace

LocalTime local_time(const almanac::Instant& when, const std::string& zone) {
  // Seconds of UTC without leap seconds, as system clocks count them.
  const auto text = almanac::utc_text(when);
  if (text.starts_with('-'))
    throw algebra::Error(fmt::format("{}: local times are known from the year 1 on", text));
  try {
    const auto local = date::make_zoned(zone, date::sys_seconds(told_by(text)));
    return {date::format("%F", local), date::format("%T", local), local.get_info().abbrev};
  } catch (const std::exception& error) {
    throw no_such_zone(zone, error);
  }
}

almanac::Instant instant_of_local(const std::string& local, const std::string& zone) {
  almanac::instant_from_utc(local);  // refuses what is no date
  try {
    const auto zoned =
        date::make_zoned(zone, date::local_seconds(told_by(local)), date::choose::earliest);
    return almanac::instant_from_utc(date::format("%FT%TZ", zoned.get_sys_time()));
  } catch (const std::exception& error) {
    throw no_such_zone(zone, error);
  }
}

}  // namespace coppermoon::uses
