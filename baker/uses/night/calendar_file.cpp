// SPDX-License-Identifier: MIT
#include "uses/night/calendar_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "algebra/error.h"
#include "almanac/calendar.h"

namespace coppermoon::uses {
namespace {

/// A moment in the format of RFC 5545, such as "20180727T202145Z".
std::string stamp(const almanac::Instant& when) {
  std::string digits;
  for (const char c : almanac::utc_text(when))
    if (c != '-' && c != ':') digits += c;
  return digits;
}

/// Folds a line as RFC 5545 requires, after at most 75 bytes and only between UTF-8 characters.
std::string line(const std::string& text) {
  std::string folded;
  std::size_t in_line = 0;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t letter = 1;
    while (i + letter < text.size() && (text[i + letter] & 0xC0) == 0x80) ++letter;
    if (in_line + letter > 75) {
      folded += "\r\n ";
      in_line = 1;
    }
    folded += text.substr(i, letter);
    in_line += letter;
    i += letter;
  }
  return folded + "\r\n";
}

/// Text with special characters escaped as in RFC 5545, section 3.3.11.
std::string escaped(const std::string& text) {
  std::string value;
  for (const char c : text) {
    if (c == ',' || c == ';' || c == '\\') value += '\\';
    value += c == '\n' ? std::string("\\n") : std::string(1, c);
  }
  return value;
}

/// Fields that all events in a file share. `place` and `coordinates` are empty if there is no place.
struct Shared {
  std::string place, coordinates, made;
};

Shared shared_by(const std::optional<almanac::Observer>& place, const std::string& place_name,
                 const almanac::Instant& made) {
  if (!place) return {{}, {}, stamp(made)};
  return {place_name,
          fmt::format("{:+.4f}{:+.4f}", algebra::in_degrees(place->latitude),
                      algebra::in_degrees(place->longitude)),
          stamp(made)};
}

/// Text of an event. An event without an end has no duration, and an event with both an end and a place has an alarm.
std::string event(const Shared& shared, const std::string& id, const almanac::Instant& from,
                  const std::optional<almanac::Instant>& to, const std::string& title,
                  const std::string& text) {
  const auto alarm = line("BEGIN:VALARM") + line("ACTION:DISPLAY") + line("TRIGGER:-PT1H") +
                     line("DESCRIPTION:" + escaped(title)) + line("END:VALARM");
  return line("BEGIN:VEVENT") + line(fmt::format("UID:{}{}@coppermoon", id, shared.coordinates)) +
         line("DTSTAMP:" + shared.made) + line("DTSTART:" + stamp(from)) +
         (to ? line("DTEND:" + stamp(*to)) : "") + line("SUMMARY:" + escaped(title)) +
         line("DESCRIPTION:" + escaped(text)) +
         (shared.place.empty() ? "" : line("LOCATION:" + escaped(shared.place))) +
         (to && !shared.place.empty() ? alarm : "") + line("END:VEVENT");
}

const char* meaning(const std::string& name) {
  if (name == "P1") return "the Moon enters the penumbra";
  if (name == "U1") return "the partial phase begins";
  if (name == "U2") return "totality begins";
  if (name == "greatest") return "greatest eclipse";
  if (name == "U3") return "totality ends";
  if (name == "U4") return "the partial phase ends";
  return "the Moon leaves the penumbra";
}

std::string name_of(const eclipse::Eclipse& eclipse) {
  return almanac::date_text(eclipse.greatest) + "-eclipse";
}

/// Text of the event for a whole eclipse at a place. The event begins at moonrise or when the Moon is first seen, and
/// ends at moonset or when the Moon is last seen.
std::string event(const Shared& shared, const Circumstances& night) {
  const auto &first = night.seen.front().first, &last = night.seen.back().second;
  auto from = first, to = last;
  for (const auto& [rise, set] : night.up) {
    const bool begins = almanac::seconds_between(*night.eclipse.contacts.P1, rise) > 0,
               ends = almanac::seconds_between(set, *night.eclipse.contacts.P4) > 0;
    if (begins && holds({rise, set}, first)) from = rise;
    if (ends && holds({rise, set}, last)) to = set;
  }
  return event(shared, name_of(night.eclipse), from, to, title(night.eclipse), what_is_seen(night));
}

std::string beginning() {
  return line("BEGIN:VCALENDAR") + line("VERSION:2.0") + line("PRODID:-//coppermoon//night//EN") +
         line("CALSCALE:GREGORIAN");
}

std::string in_a_sentence(const eclipse::Eclipse& eclipse) {
  return fmt::format("Greatest at {} UTC, umbral magnitude {:.2f}.",
                     almanac::time_of_day_text(eclipse.greatest), eclipse.umbral_magnitude);
}

}  // namespace

void require_in_calendars(const std::vector<eclipse::Eclipse>& eclipses) {
  if (eclipses.empty())
    throw algebra::Error("no eclipse: a calendar has an event at least, allowed .csv or .json");
  for (const auto& each : eclipses)
    if (const auto first = almanac::utc_text(*each.contacts.P1);
        first.starts_with('-') || first.starts_with("0000"))
      throw algebra::Error(
          fmt::format("eclipse of {}: iCalendar has no years before 1, allowed .csv or .json",
                      almanac::date_text(each.greatest, each.calendar)));
}

void require_in_calendars(const std::vector<Circumstances>& nights, const std::string& place_name) {
  std::vector<eclipse::Eclipse> eclipses;
  for (const auto& each : nights) eclipses.push_back(each.eclipse);
  require_in_calendars(eclipses);
  if (std::ranges::all_of(nights, [](const auto& each) { return each.seen.empty(); }))
    throw algebra::Error(fmt::format("{} sees nothing of {}: no event for a calendar", place_name,
                                     nights.size() == 1 ? "the eclipse" : "these eclipses"));
}

std::string as_calendar(const std::vector<eclipse::Eclipse>& eclipses,
                        const almanac::Instant& made) {
  require_in_calendars(eclipses);
  const auto shared = shared_by({}, {}, made);
  auto text = beginning();
  for (const auto& each : eclipses)
    text += event(shared, name_of(each), *each.contacts.P1, *each.contacts.P4, title(each),
                  in_a_sentence(each));
  return text + line("END:VCALENDAR");
}

std::string as_calendar(const std::vector<Circumstances>& nights, const std::string& place_name,
                        const almanac::Instant& made) {
  require_in_calendars(nights, place_name);
  auto text = beginning();
  for (const auto& each : nights)
    if (!each.seen.empty()) text += event(shared_by(each.place, place_name, made), each);
  return text + line("END:VCALENDAR");
}

std::string as_calendar(const Circumstances& night, const std::string& place_name,
                        const almanac::Instant& made) {
  require_in_calendars({night}, place_name);
  const auto day = almanac::date_text(night.eclipse.greatest);
  const auto shared = shared_by(night.place, place_name, made);
  auto text = beginning() + event(shared, night);
  for (const auto& moment : night.moments) {
    if (moment.name.starts_with("moon") || !is_seen(night, moment.when)) continue;
    const auto where = fmt::format("The Moon is {:.0f} degrees high, in azimuth {:.0f}.",
                                   algebra::in_degrees(moment.moon.altitude),
                                   algebra::in_degrees(moment.moon.azimuth));
    text += event(shared, day + "-" + moment.name.substr(0, moment.name.find(' ')), moment.when, {},
                  moment.name.ends_with(" seen")
                      ? "the Moon is " + moment.name
                      : fmt::format("{}: {}", moment.name, meaning(moment.name)),
                  where);
  }
  return text + line("END:VCALENDAR");
}

}  // namespace coppermoon::uses
