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

/// Moment as the flags give it.
struct MomentOptions {
  std::string text;
  almanac::Calendar calendar = almanac::Calendar::gregorian;
  std::string zone = {};  ///< of times of day without an offset; empty: UTC
};

/// Adds the moment, with or without --instant before it, --calendar and --zone.
///
/// Given  more  for help: other things that may stand in the moment's place
request::Parameter& add_moment_options(Verb& verb, MomentOptions& options, const std::string& more = "");

/// Adds --calendar.
void add_calendar_option(Verb& verb, almanac::Calendar& calendar);

/// Adds --zone, of the clock times that a command line gives.
void add_zone_option(Verb& verb, std::string& zone);

/// Adds the key `calendar` to a document whose dates are not Gregorian.
void say_calendar(nlohmann::ordered_json& document, almanac::Calendar calendar);

/// The moment that is meant (uses::moment_in). Where it is given by another name, as a day or a contact, the program says
/// on stderr which it is.
///
/// Given   observer  whose days, moonrise and moonset are meant
/// Throws  Error     as uses::moment_in
almanac::Instant instant_of(const MomentOptions& options,
                            const std::optional<almanac::Observer>& observer = {});

/// Says on stderr which city is taken, where the name behind --at leaves a doubt (almanac::city_taken). A city of the
/// user's own becomes numbers in recipes, which others can read.
void say_which_city(Verb& verb);

/// Says on stderr which times of a command line with a place in it are read as UTC for want of an offset.
void say_what_is_utc(const Verb& verb);

/// Says on stderr whose clocks a place has, where no city is near (uses::whose_clocks).
void say_whose_clocks(const almanac::Observer& observer);

}  // namespace coppermoon::verbs
