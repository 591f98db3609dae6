// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// Moment as the flags give it.
struct MomentOptions {
  std::string text;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
};

/// Adds the moment, with or without --instant before it, and --calendar.
///
/// Given  more  for help: other things that may stand in the moment's place
Flag add_moment_options(CLI::App& verb, MomentOptions& options, const std::string& more = "");

/// Adds --calendar.
void add_calendar_option(CLI::App& verb, almanac::Calendar& calendar);

/// Adds the key `calendar` to a document whose dates are not Gregorian.
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

/// Command line in which a day and the contact or time behind it are one argument: "2018-07-27", "U2+10min" become
/// "2018-07-27 U2+10min".
std::vector<std::string> with_moments_joined(const std::vector<std::string>& arguments);

}  // namespace coppermoon::verbs
