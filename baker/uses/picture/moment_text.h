// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Place, time zone and calendar for reading a text that names a moment.
struct MomentContext {
  std::optional<almanac::Observer> observer{};
  /// Zone for times of day without an offset: one that local_time takes, or "local" for the place's; if empty, UTC.
  /// Days may be those of UTC, and of this zone or the place's too.
  std::string zone{};
  almanac::Calendar calendar = almanac::Calendar::gregorian;
};

/// The moment that a text names: an instant, "2018-07-27T18:24:00Z"; a day, "2018-07-27", for its greatest eclipse; or
/// a day with a contact of that eclipse, moonrise or moonset: "2018-07-27 U2+10min", "2018-07-27 moonrise+20min".
///
/// Returned  rounded to the second for a day alone, a contact, moonrise or moonset
/// Throws    Error  when the text names no moment; when the day has no eclipse (the error names the nearest)
almanac::Instant moment_in(const std::string& text, const MomentContext& context = {});

/// The moment that a text gives as an instant, or relative to a contact of an eclipse, moonrise or moonset. Moonrise is
/// the last one before P4, moonset the first one after P1.
///
/// Throws  Error  when the text is neither, the eclipse has no such contact, or the Moon does not rise or set there
almanac::Instant moment_from(const std::string& text, const eclipse::Eclipse& eclipse,
                             const MomentContext& context = {});

/// The eclipse of a day: greatest on that day in UTC, or in local time on that day or the night after it (until noon).
std::optional<eclipse::Eclipse> eclipse_of_day(const std::string& day,
                                               const MomentContext& context = {});

/// As eclipse_of_day.
///
/// Throws  Error  when the day has no eclipse: names the nearest one
eclipse::Eclipse eclipse_on(const std::string& day, const MomentContext& context = {});

}  // namespace coppermoon::uses
