// SPDX-License-Identifier: MIT
#include "uses/night/local_time.h"

#include <date/tz.h>
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <exception>

#include "algebra/error.h"

namespace coppermoon::uses {

LocalTime local_time(const almanac::Instant& when, const std::string& zone) {
  // Seconds of UTC without leap seconds, as system clocks count them.
  const auto text = almanac::utc_text(when);
  if (text.starts_with('-'))
    throw algebra::Error(fmt::format("{}: local times are known from the year 1 on", text));
  const auto part = [&](std::size_t from, std::size_t count) {
    return std::stoi(text.substr(from, count));
  };
  const auto day = date::year(part(0, 4)) / part(5, 2) / part(8, 2);
  const auto utc = date::sys_days(day) + std::chrono::hours(part(11, 2)) +
                   std::chrono::minutes(part(14, 2)) + std::chrono::seconds(part(17, 2));
  try {
    const auto local = date::make_zoned(zone, utc);
    return {date::format("%F", local), date::format("%T", local), local.get_info().abbrev};
  } catch (const std::exception& error) {
    throw algebra::Error(
        fmt::format("time zone {}: not in this system's zoneinfo ({})", zone, error.what()));
  }
}

}  // namespace coppermoon::uses
