// SPDX-License-Identifier: MIT
#include "eclipse/moment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "algebra/error.h"
#include "algebra/number.h"
#include "almanac/calendar.h"

namespace coppermoon::eclipse {
namespace {

using almanac::Instant;

constexpr double half_a_month_s = 15 * 86400.;
constexpr auto usual = ShadowConvention::danjon;

/// Contact and seconds after it, of a text as "P1-10min".
struct FromContact {
  std::string name;
  std::optional<double> seconds;
};

FromContact from_contact(const std::string& text) {
  const auto sign = text.find_first_of("+-");
  if (sign == std::string::npos) return {text, 0};
  const auto seconds =
      algebra::number_with_unit(text.substr(sign + 1), {{"min", 60}, {"h", 3600}, {"s", 1}});
  const double way = text[sign] == '-' ? -1 : 1;
  const bool near =
      seconds && std::abs(*seconds) <= half_a_month_s;  // not so where it is no number
  return {text.substr(0, sign), near ? std::optional(way * *seconds) : std::nullopt};
}

/// Whether a text matches a whole pattern, in which 0 stands for any digit.
bool is_like(std::string_view text, std::string_view pattern) {
  return text.size() == pattern.size() &&
         std::ranges::equal(text, pattern, [](char letter, char wanted) {
           return wanted == '0' ? letter >= '0' && letter <= '9' : letter == wanted;
         });
}

Instant to_the_second(const Instant& when) {
  return almanac::instant_from_utc(almanac::utc_text(when));
}

}  // namespace

bool is_day(std::string_view text) {
  return is_like(text, "0000-00-00") || is_like(text, "-0000-00-00") ||
         is_like(text, "+0000-00-00");
}

bool is_contact_or_time(std::string_view text) {
  return is_like(text.substr(0, 5), "00:00") || is_like(text.substr(0, 2), "P0") ||
         is_like(text.substr(0, 2), "U0") || text.starts_with("greatest");
}

bool begins_with_digit(const std::string& text) {
  return !text.empty() && text.find_first_of("0123456789") <= (text.front() == '-' ? 1 : 0);
}

bool is_from_contact(const std::string& text) {
  const auto space = text.find(' ');
  return space != std::string::npos && !begins_with_digit(text.substr(space + 1));
}

Instant moment_in(const std::string& text, almanac::Calendar calendar) {
  if (is_day(text)) return to_the_second(eclipse_on(text, calendar).greatest);
  if (!is_from_contact(text)) return almanac::instant_from_utc(text, calendar);
  const auto space = text.find(' ');
  return to_the_second(
      moment_from(text.substr(space + 1), eclipse_on(text.substr(0, space), calendar)));
}

Instant moment_from(const std::string& text, const Eclipse& eclipse, almanac::Calendar calendar) {
  if (begins_with_digit(text)) return almanac::instant_from_utc(text, calendar);
  const auto [name, seconds] = from_contact(text);
  std::vector<std::string> names;
  for (const auto& [contact, when] : contacts_of(eclipse)) {
    if (contact == name && seconds) return almanac::later(when, *seconds);
    names.push_back(contact);
  }
  throw algebra::Error(fmt::format(
      "moment = {}, allowed an instant or one of {} of the eclipse of {}, as {}-10min", text,
      fmt::join(names, ", "), almanac::date_text(eclipse.greatest, calendar), names.front()));
}

Eclipse eclipse_on(const std::string& day, almanac::Calendar calendar) {
  const auto midnight = almanac::instant_from_utc(day, calendar);
  if (auto eclipse = eclipse_of_day(midnight, usual)) {
    eclipse->calendar = calendar;
    return *eclipse;
  }
  const auto nearest = nearest_eclipse(almanac::later(midnight, 43200), usual);
  throw algebra::Error(
      fmt::format("{}: no lunar eclipse is greatest on that day (UTC); the nearest is at {}. Any "
                  "other moment needs a time of day, as {}T21:30Z",
                  day, almanac::utc_text(nearest.greatest, calendar), day));
}

}  // namespace coppermoon::eclipse
