// SPDX-License-Identifier: MIT
#include "uses/picture/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "almanac/gazetteer.h"
#include "uses/picture/local_time.h"
#include "uses/picture/photo_file.h"

namespace coppermoon::uses {
namespace {

std::string degrees_text(double degrees, const char* positive, const char* negative) {
  return fmt::format("{:.2f}° {}", std::abs(degrees), degrees < 0 ? negative : positive);
}

/// The moment in a header's capDate, such as "2018:07:27 20:21:45".
almanac::Instant moment_of(const texture::Attributes& header) {
  const auto date = header.find("capDate");
  const auto clock =
      date == header.end() ? std::nullopt : clock_in(std::get<std::string>(date->second));
  if (!clock) throw algebra::Error("caption: the frame's header has no capDate");
  return almanac::instant_from_utc(clock->local + 'Z');
}

std::optional<almanac::Observer> observer_of(const texture::Attributes& header) {
  const auto latitude = header.find("latitude"), longitude = header.find("longitude");
  if (latitude == header.end() || longitude == header.end()) return std::nullopt;
  return almanac::Observer{algebra::degrees(double{std::get<float>(latitude->second)}),
                           algebra::degrees(double{std::get<float>(longitude->second)}),
                           {}};
}

}  // namespace

std::string place_in_words(const almanac::Observer& observer) {
  constexpr double near_km = 10;
  const auto city = almanac::nearest_city(observer);
  if (algebra::in_kilometres(almanac::distance_between(observer, city.place)) < near_km)
    return city.name;
  return degrees_text(algebra::in_degrees(observer.latitude), "N", "S") + ", " +
         degrees_text(algebra::in_degrees(observer.longitude), "E", "W");
}

std::string from_nearest_contact(const eclipse::Eclipse& eclipse, const almanac::Instant& when) {
  const auto contacts = eclipse::contacts_of(eclipse);
  const auto& [name, contact] = *std::ranges::min_element(contacts, {}, [&](const auto& one) {
    return std::abs(almanac::seconds_between(one.second, when));
  });
  return from_contact(name, almanac::seconds_between(contact, when));
}

std::string from_contact(const std::string& name, double seconds) {
  const double away = std::abs(seconds);
  if (away < 0.5) return name;
  return fmt::format(
      "{}{}{}", name, seconds < 0 ? '-' : '+',
      away < 59.5 ? fmt::format("{:.0f}s", away) : fmt::format("{:.0f}min", away / 60));
}

Caption caption_of(const texture::Attributes& header) {
  const auto when = moment_of(header);
  const auto observer = observer_of(header);
  const auto local = local_time(when, observer ? zone_or_utc(*observer) : "+00:00");
  Caption caption{
      fmt::format("{} {} {}", local.date, local.time,
                  observer ? local.abbreviation + ", " + place_in_words(*observer) : "UTC"),
      ""};
  if (const auto eclipse = eclipse::eclipse_at(when, eclipse::ShadowConvention::danjon))
    caption.right = from_nearest_contact(*eclipse, when);
  return caption;
}

}  // namespace coppermoon::uses
