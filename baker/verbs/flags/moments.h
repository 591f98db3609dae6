// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A moment as flags tell it.
struct MomentOptions {
  std::string text;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
};

/// The moment, without a name or as --instant, and --calendar.
///
/// Given  more  what else may stand in the moment's place, for the help
Flag add_moment_options(CLI::App& verb, MomentOptions& options, const std::string& more = "");

/// --calendar.
void add_calendar_option(CLI::App& verb, almanac::Calendar& calendar);

/// Names the calendar of a document's dates, where it is not the one of ISO 8601.
void say_calendar(nlohmann::ordered_json& document, almanac::Calendar calendar);

/// The moment that is meant. Of a day alone it is the greatest eclipse of that day (UTC), and the
/// program says so on stderr; of a day and a contact, as "2018-07-27 U2+10min", that of the day's
/// eclipse. Both to the full second, which is what is said.
///
/// Throws  Error  when the text is no moment; when the day has no eclipse: names the nearest
almanac::Instant instant_of(const MomentOptions& options);

/// Says on stderr which city is taken, where the name behind --at leaves a doubt (almanac::city_taken).
void say_which_city(const CLI::App& verb);

/// Says on stderr which times of a command line with a place in it are read as UTC for want of an offset.
void say_what_is_utc(const CLI::App& verb);

/// A command line in which a day and the contact, or the time of day, behind it are one argument:
/// "2018-07-27", "U2+10min" become "2018-07-27 U2+10min".
std::vector<std::string> with_moments_joined(const std::vector<std::string>& arguments);

}  // namespace coppermoon::verbs
