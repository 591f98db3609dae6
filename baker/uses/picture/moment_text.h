// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Place, time zone and calendar for reading a string that names a moment.
struct MomentContext {
  std::optional<almanac::Observer> observer{};
  /// Time zone for times of day without an offset: a zone that local_time accepts, or "local" for the place's zone. If
  /// `zone` is empty, such times are in UTC. A day names the eclipse on that day in UTC. If there is none, it names the
  /// eclipse on that day in this zone or, if `zone` is empty, in the place's zone.
  std::string zone{};
  almanac::Calendar calendar = almanac::Calendar::gregorian;
};

/// The moment that a string names: an instant, "2018-07-27T18:24:00Z"; a day, "2018-07-27", for the greatest eclipse on
/// that day; or a day followed by a contact of its eclipse, moonrise or moonset, "2018-07-27 U2+10min".
///
/// Returned  rounded to the second, unless the text is an instant
/// Throws    Error  when the text names no moment; when the day has no eclipse (the message names the nearest one)
almanac::Instant moment_in(const std::string& text, const MomentContext& context = {});

/// The moment that a string gives as an instant, or relative to a contact of an eclipse, to moonrise or to moonset. The
/// moonrise is the last one before P4, and the moonset is the first one after P1.
///
/// Throws  Error  when the text has no such form, the eclipse lacks the contact, or the Moon does not rise or set
almanac::Instant moment_from(const std::string& text, const eclipse::Eclipse& eclipse,
                             const MomentContext& context = {});

/// The eclipse whose maximum falls on a day in UTC or, in local time, on that day or the following night (until noon).
std::optional<eclipse::Eclipse> eclipse_of_day(const std::string& day,
                                               const MomentContext& context = {});

/// Like eclipse_of_day, for a day that must have an eclipse.
///
/// Throws  Error  when the day has no eclipse; the message names the nearest one
eclipse::Eclipse eclipse_on(const std::string& day, const MomentContext& context = {});

}  // namespace coppermoon::uses
