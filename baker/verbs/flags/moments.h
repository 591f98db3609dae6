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

/// A moment as text, and the flags that determine how the text is interpreted.
struct MomentOptions {
  std::string text;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  std::string zone = {};  ///< time zone for times without an offset; if empty, UTC
};

/// Adds --calendar, --zone and --instant. The moment may also be given without the flag --instant.
///
/// Given  more  text to append to the help, about what may be given in place of the moment
request::Parameter& add_moment_options(Verb& verb, MomentOptions& options,
                                       const std::string& more = "");

/// Adds --calendar, the calendar of dates on the command line.
void add_calendar_option(Verb& verb, almanac::Calendar& calendar);

/// Adds --zone, the time zone of clock times on the command line.
void add_zone_option(Verb& verb, std::string& zone);

/// Adds the key `calendar` to a document if its dates are not Gregorian.
void say_calendar(nlohmann::ordered_json& document, almanac::Calendar calendar);

/// The moment that the options mean (uses::moment_in). If they give, for instance, a day or a contact instead of a
/// time, the resulting moment is reported on stderr.
///
/// Given   observer  the observer to whom days, moonrise and moonset refer
/// Throws  Error     like uses::moment_in
almanac::Instant instant_of(const MomentOptions& options,
                            const std::optional<almanac::Observer>& observer = {});

/// Reports on stderr which city is taken if the name after --at is ambiguous (almanac::city_taken). In recipes, a city
/// that the user defined is replaced by its coordinates, so that others can use the recipe.
void say_which_city(Verb& verb);

/// Reports on stderr which times are read as UTC, because they have no offset, although the command line names a place.
void say_what_is_utc(const Verb& verb);

/// Reports on stderr how local time is chosen for a place without a city nearby (uses::whose_clocks).
void say_whose_clocks(const almanac::Observer& observer);

}  // namespace coppermoon::verbs
