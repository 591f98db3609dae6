// SPDX-License-Identifier: MIT
#include "verbs/flags/moments.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "algebra/error.h"
#include "almanac/calendar.h"
#include "almanac/gazetteer.h"
#include "eclipse/moment.h"
#include "uses/picture/local_time.h"
#include "uses/picture/moment_text.h"
#include "uses/picture/place_text.h"

namespace coppermoon::verbs {
namespace {

using almanac::Instant;

/// Reports on stderr which moment is meant by text such as a day or a contact.
void say(const std::string& asked, const Instant& when, almanac::Calendar calendar) {
  fmt::print(stderr, "coppermoon: {} is {} {} UTC\n", asked, almanac::date_text(when, calendar),
             almanac::time_of_day_text(when));
}

}  // namespace

request::Parameter& add_moment_options(Verb& verb, MomentOptions& options,
                                       const std::string& more) {
  auto& flag = add_flag(
      verb, "instant,--instant", options.text,
      "moment in UTC: 2018-07-27T20:21:45Z; a day alone is its greatest eclipse; a day and a "
      "contact, as 2018-07-27 U2+10min, or moonrise or moonset" +
          more);
  add_calendar_option(verb, options.calendar);
  add_zone_option(verb, options.zone);
  return flag;
}

void add_calendar_option(Verb& verb, almanac::Calendar& calendar) {
  add_choice<almanac::Calendar>(
      verb, "--calendar", calendar,
      {{"gregorian", almanac::Calendar::gregorian}, {"julian", almanac::Calendar::julian}},
      "calendar of all dates, also of what is printed; historians give Julian dates before October "
      "1582");
}

void add_zone_option(Verb& verb, std::string& zone) {
  add_flag(
      verb, "--zone", zone,
      "time zone of times of day without an offset: local, that of the place, an IANA name, as "
      "Europe/Berlin, or an offset, as +02:00; default: UTC");
}

void say_calendar(nlohmann::ordered_json& document, almanac::Calendar calendar) {
  if (calendar == almanac::Calendar::julian) document["calendar"] = "julian";
}

Instant instant_of(const MomentOptions& options, const std::optional<almanac::Observer>& observer) {
  const auto& [text, calendar, zone] = options;
  const auto moment = uses::moment_in(text, {observer, zone, calendar});
  if (eclipse::is_day(text))
    say("the greatest eclipse of " + text, moment, calendar);
  else if (eclipse::is_from_contact(text))
    say(text, moment, calendar);
  return moment;
}

void say_which_city(Verb& verb) {
  if (!is_given(verb, "at")) return;
  auto& at = *verb.parameters.find("at");
  if (const auto taken = almanac::city_taken(at.text()); !taken.empty())
    fmt::print(stderr, "coppermoon: {}\n", taken);
  if (const auto city = almanac::city_named(at.text()); city && city->own)
    at.given = {uses::exact_text(city->place)};
}

void say_what_is_utc(const Verb& verb) {
  if (!is_given(verb, "at") || is_given(verb, "zone")) return;
  const bool zoned = verb.parameters.find("zone") != nullptr;
  for (const char* name : {"instant", "from", "to"})
    if (is_given(verb, name))
      if (const auto moment = verb.parameters.find(name)->text(); eclipse::is_clock_time(moment))
        fmt::print(stderr,
                   "coppermoon: {} is read as UTC; {}an offset, as {}+02:00, says otherwise\n",
                   moment, zoned ? "--zone local, or " : "", moment);
}

void say_whose_clocks(const almanac::Observer& observer) {
  if (uses::time_zone_of(observer) != almanac::nearest_city(observer).time_zone)
    fmt::print(stderr, "coppermoon: {}\n", uses::whose_clocks(observer));
}

}  // namespace coppermoon::verbs
