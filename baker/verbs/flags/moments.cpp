// SPDX-License-Identifier: MIT
#include "verbs/flags/moments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>

#include "algebra/error.h"
#include "algebra/number.h"
#include "verbs/flags/number_with_unit.h"

namespace coppermoon::verbs {
namespace {

using almanac::Instant;

constexpr double half_a_month_s = 15 * 86400.;
constexpr auto convention = eclipse::ShadowConvention::danjon;

/// The contact of "P1-10min", and the seconds from it on.
struct FromContact {
  std::string name;
  std::optional<double> seconds;
};

FromContact from_contact(const std::string& text) {
  const auto sign = text.find_first_of("+-");
  if (sign == std::string::npos) return {text, 0};
  const auto seconds =
      number_with_unit(text.substr(sign + 1), {{"min", 60}, {"h", 3600}, {"s", 1}});
  const double way = text[sign] == '-' ? -1 : 1;
  const bool near =
      seconds && std::abs(*seconds) <= half_a_month_s;  // not so where it is no number
  return {text.substr(0, sign), near ? std::optional(way * *seconds) : std::nullopt};
}

/// Whether a text is of a pattern in which 0 stands for any digit, and ends where it ends.
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

/// Whether a text begins as a time of day or a contact does.
bool is_contact_or_time(std::string_view text) {
  return is_like(text.substr(0, 5), "00:00") || is_like(text.substr(0, 2), "P0") ||
         is_like(text.substr(0, 2), "U0") || text.starts_with("greatest");
}

eclipse::Eclipse eclipse_on(const std::string& day, almanac::Calendar calendar) {
  const auto midnight = almanac::instant_from_utc(day, calendar);
  if (const auto eclipse = eclipse::eclipse_of_day(midnight, convention)) return *eclipse;
  const auto nearest = eclipse::nearest_eclipse(almanac::later(midnight, 43200), convention);
  throw algebra::Error(
      fmt::format("{}: no lunar eclipse is greatest on that day (UTC); the nearest is at {}. Any "
                  "other moment needs a time of day, as {}T21:30Z",
                  day, almanac::utc_text(nearest.greatest), day));
}

/// A moment to the full second, said to whoever asked for it by another name.
Instant said(const std::string& asked, const Instant& when) {
  auto text = almanac::utc_text(when);
  const auto instant = almanac::instant_from_utc(text);
  std::ranges::replace(text, 'T', ' ');
  text.pop_back();
  fmt::print(stderr, "coppermoon: {} is {} UTC\n", asked, text);
  return instant;
}

}  // namespace

bool begins_with_digit(const std::string& text) {
  return !text.empty() && text.find_first_of("0123456789") <= (text.front() == '-' ? 1 : 0);
}

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
      "calendar of the date; historians give Julian dates before October 1582");
}

Instant instant_of(const MomentOptions& options) {
  const auto& text = options.text;
  if (is_day(text))
    return said("the greatest eclipse of " + text, eclipse_on(text, options.calendar).greatest);
  const auto space = text.find(' ');
  if (space == std::string::npos || begins_with_digit(text.substr(space + 1)))
    return almanac::instant_from_utc(text, options.calendar);
  const auto contact = text.substr(space + 1);
  return said(text, moment_from(contact, eclipse_on(text.substr(0, space), options.calendar)));
}

Instant moment_from(const std::string& text, const eclipse::Eclipse& eclipse,
                    almanac::Calendar calendar) {
  if (begins_with_digit(text)) return almanac::instant_from_utc(text, calendar);
  const auto [name, seconds] = from_contact(text);
  std::vector<std::string> names;
  for (const auto& [contact, when] : contacts_of(eclipse)) {
    if (contact == name && seconds) return almanac::later(when, *seconds);
    names.push_back(contact);
  }
  throw algebra::Error(fmt::format(
      "moment = {}, allowed an instant or one of {} of the eclipse of {}, as {}-10min", text,
      fmt::join(names, ", "), almanac::utc_text(eclipse.greatest).substr(0, 10), names.front()));
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

std::optional<double> exposure_seconds(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return algebra::number_in(text);
  const auto over = algebra::number_in(text.substr(0, slash)),
             under = algebra::number_in(text.substr(slash + 1));
  return over && under && *under > 0 ? std::optional(*over / *under) : std::nullopt;
}

}  // namespace coppermoon::verbs
