// SPDX-License-Identifier: MIT
#include "verbs/flags/moments.h"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/calendar.h"
#include "almanac/gazetteer.h"
#include "eclipse/moment.h"

namespace coppermoon::verbs {
namespace {

using almanac::Instant;

/// Says on stderr which moment is meant by another name.
void say(const std::string& asked, const Instant& when, almanac::Calendar calendar) {
  fmt::print(stderr, "coppermoon: {} is {} {} UTC\n", asked, almanac::date_text(when, calendar),
             almanac::time_of_day_text(when));
}

/// Whether a text has a time of day without an offset.
bool is_silently_utc(std::string_view text) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos || !eclipse::begins_with_digit(std::string(text)))
    return false;
  return text.find_first_not_of("0123456789:.", colon) == std::string_view::npos;
}

}  // namespace

Flag add_moment_options(CLI::App& verb, MomentOptions& options, const std::string& more) {
  const auto flag = add_flag(
      verb, "instant,--instant", options.text,
      "moment in UTC: 2018-07-27T20:21:45Z; a day alone is its greatest eclipse; a day and a "
      "contact, as 2018-07-27 U2+10min" +
          more);
  add_calendar_option(verb, options.calendar);
  return flag;
}

void add_calendar_option(CLI::App& verb, almanac::Calendar& calendar) {
  add_choice<almanac::Calendar>(
      verb, "--calendar", calendar,
      {{"gregorian", almanac::Calendar::gregorian}, {"julian", almanac::Calendar::julian}},
      "calendar of all dates, also of what is printed; historians give Julian dates before October "
      "1582");
}

void say_calendar(nlohmann::ordered_json& document, almanac::Calendar calendar) {
  if (calendar == almanac::Calendar::julian) document["calendar"] = "julian";
}

Instant instant_of(const MomentOptions& options) {
  const auto& [text, calendar] = options;
  const auto moment = eclipse::moment_in(text, calendar);
  if (eclipse::is_day(text))
    say("the greatest eclipse of " + text, moment, calendar);
  else if (eclipse::is_from_contact(text))
    say(text, moment, calendar);
  return moment;
}

void say_which_city(const CLI::App& verb) {
  if (!is_given(verb, "at")) return;
  if (const auto taken = almanac::city_taken(parameters_of(verb).find("at")->text());
      !taken.empty())
    fmt::print(stderr, "coppermoon: {}\n", taken);
}

void say_what_is_utc(const CLI::App& verb) {
  if (!is_given(verb, "at")) return;
  for (const char* name : {"instant", "from", "to"})
    if (is_given(verb, name))
      if (const auto moment = parameters_of(verb).find(name)->text(); is_silently_utc(moment))
        fmt::print(stderr,
                   "coppermoon: {} is read as UTC; an offset, as {}+02:00, says otherwise\n",
                   moment, moment);
}

std::vector<std::string> with_moments_joined(const std::vector<std::string>& arguments) {
  std::vector<std::string> all;
  for (const auto& argument : arguments) {
    if (!all.empty() && eclipse::is_day(all.back()) && eclipse::is_contact_or_time(argument))
      all.back() += " " + argument;
    else
      all.push_back(argument);
  }
  return all;
}

}  // namespace coppermoon::verbs
