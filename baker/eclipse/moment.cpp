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

/// Moment relative to a contact, read from a string such as "P1-10min": the contact's name, and the seconds after it.
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
  const bool near = seconds && std::abs(*seconds) <= half_a_month_s;  // false for NaN
  return {text.substr(0, sign), near ? std::optional(way * *seconds) : std::nullopt};
}

/// Whether a text, as a whole, matches a pattern in which 0 stands for any digit.
bool is_like(std::string_view text, std::string_view pattern) {
  return text.size() == pattern.size() &&
         std::ranges::equal(text, pattern, [](char letter, char wanted) {
           return wanted == '0' ? letter >= '0' && letter <= '9' : letter == wanted;
         });
}

/// Converts a string to lower case and removes its spaces.
std::string plain(std::string_view text) {
  std::string letters;
  for (const char letter : text)
    if (letter != ' ')
      letters += letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  return letters;
}

}  // namespace

bool is_day(std::string_view text) {
  return is_like(text, "0000-00-00") || is_like(text, "-0000-00-00") ||
         is_like(text, "+0000-00-00") || is_like(text, "00000000");
}

bool is_clock_time(std::string_view text) {
  const auto day_ends = text.find_first_of("Tt ");
  return day_ends != std::string_view::npos && is_day(text.substr(0, day_ends)) &&
         text.find_first_not_of("0123456789:.", day_ends + 1) == std::string_view::npos;
}

bool is_contact_or_time(std::string_view text) {
  const auto word = plain(text);
  return is_like(word.substr(0, 5), "00:00") || is_like(word.substr(0, 2), "p0") ||
         is_like(word.substr(0, 2), "u0") || word.starts_with("greatest") || is_from_horizon(word);
}

bool begins_with_digit(const std::string& text) {
  return !text.empty() && text.find_first_of("0123456789") <= (text.front() == '-' ? 1 : 0);
}

bool is_from_contact(const std::string& text) {
  const auto space = text.find(' ');
  return space != std::string::npos && !begins_with_digit(text.substr(space + 1));
}

bool is_from_horizon(const std::string& text) {
  const auto word = plain(text.substr(0, text.find_first_of("+-")));
  return word == "moonrise" || word == "moonset";
}

Instant moment_from(const std::string& text, const Eclipse& eclipse,
                    const std::vector<std::pair<std::string, Instant>>& others) {
  const auto [name, seconds] = from_contact(plain(text));
  auto known = contacts_of(eclipse);
  known.insert(known.end(), others.begin(), others.end());
  std::vector<std::string> names;
  for (const auto& [contact, when] : known) {
    if (plain(contact) == name && seconds) return almanac::later(when, *seconds);
    names.push_back(contact);
  }
  throw algebra::Error(
      fmt::format("moment = {}, allowed an instant or one of {} of the eclipse of {}, as {}-10min",
                  text, fmt::join(names, ", "),
                  almanac::date_text(eclipse.greatest, eclipse.calendar), names.front()));
}

}  // namespace coppermoon::eclipse
