// SPDX-License-Identifier: MIT
#include "verbs/flags/moments.h"

#include <fmt/format.h>

#include <algorithm>
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

/// Whether a text matches a pattern in which 0 stands for any digit.
bool is_like(std::string_view text, std::string_view pattern) {
  return text.size() == pattern.size() &&
         std::ranges::equal(text, pattern, [](char letter, char wanted) {
           return wanted == '0' ? letter >= '0' && letter <= '9' : letter == wanted;
         });
}

bool is_day(std::string_view text) {
  return is_like(text, "0000-00-00") || is_like(text, "-0000-00-00") ||
         is_like(text, "+0000-00-00");
}

/// Whether a text begins like a time of day or a contact.
bool is_contact_or_time(std::string_view text) {
  return is_like(text.substr(0, 5), "00:00") || is_like(text.substr(0, 2), "P0") ||
         is_like(text.substr(0, 2), "U0") || text.starts_with("greatest");
}

/// Moment rounded to the full second, which is said on stderr.
Instant said(const std::string& asked, const Instant& when, almanac::Calendar calendar) {
  fmt::print(stderr, "coppermoon: {} is {} {} UTC\n", asked, almanac::date_text(when, calendar),
             almanac::time_of_day_text(when));
  return almanac::instant_from_utc(almanac::utc_text(when));
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
  const auto& text = options.text;
  if (is_day(text))
    return said("the greatest eclipse of " + text,
                eclipse::eclipse_on(text, options.calendar).greatest, options.calendar);
  const auto moment = eclipse::moment_in(text, options.calendar);
  return eclipse::is_from_contact(text) ? said(text, moment, options.calendar) : moment;
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
    if (!all.empty() && is_day(all.back()) && is_contact_or_time(argument))
      all.back() += " " + argument;
    else
      all.push_back(argument);
  }
  return all;
}

}  // namespace coppermoon::verbs
