// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"
#include "verbs/flags/flags.h"

namespace coppermoon::verbs {

/// A moment as the flags give it.
struct MomentOptions {
  std::string text;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  std::string zone = {};  ///< time zone for times of day without an offset; empty: UTC
};

/// Adds --calendar, --zone, and the moment, which may be given with or without --instant.
///
/// Given  more  what else may be given in place of the moment, for help
request::Parameter& add_moment_options(Verb& verb, MomentOptions& options,
                                       const std::string& more = "");

/// Adds --calendar.
void add_calendar_option(Verb& verb, almanac::Calendar& calendar);

/// Adds --zone, the time zone for clock times on the command line.
void add_zone_option(Verb& verb, std::string& zone);

/// Adds the key `calendar` to a document whose dates are not Gregorian.
void say_calendar(nlohmann::ordered_json& document, almanac::Calendar calendar);

/// The moment that the options mean (uses::moment_in). If they name it otherwise than by its time, such as by a day or
/// a contact, the program says on stderr which moment that is.
///
/// Given   observer  the observer to whom days, moonrise and moonset refer
/// Throws  Error     as uses::moment_in
almanac::Instant instant_of(const MomentOptions& options,
                            const std::optional<almanac::Observer>& observer = {});

/// Says on stderr which city is taken if the name after --at is ambiguous (almanac::city_taken). A city that only the
/// user defined becomes coordinates in recipes, so that others can use them.
void say_which_city(Verb& verb);

/// Says on stderr which times are read as UTC because they have no offset, although the command line names a place.
void say_what_is_utc(const Verb& verb);

/// Says on stderr whose local time is used for a place if no city is near it (uses::whose_clocks).
void say_whose_clocks(const almanac::Observer& observer);

}  // namespace coppermoon::verbs
