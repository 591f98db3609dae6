// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"
#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Place, clocks and calendar by which a text names a moment.
struct MomentContext {
  std::optional<almanac::Observer> observer{};
  /// Of times of day without an offset: a zone as of local_time, or "local", the place's; empty: UTC. Days are those
  /// of UTC, and of this zone or the place's too.
  std::string zone{};
  almanac::Calendar calendar = almanac::Calendar::gregorian;
};

/// Moment of a text: an instant, "2018-07-27T18:24:00Z"; a day, "2018-07-27", which stands for its greatest eclipse; or
/// a day and a contact of that eclipse, or moonrise or moonset, "2018-07-27 U2+10min", "2018-07-27 moonrise+20min".
///
/// Returned  rounded to the second for a day alone, a contact, moonrise or moonset
/// Throws    Error  when the text is no moment; when the day has no eclipse: names the nearest eclipse
almanac::Instant moment_in(const std::string& text, const MomentContext& context = {});

/// Instant of a text that is an instant, or relative to a contact of an eclipse, moonrise or moonset. Moonrise is the
/// last one before P4, moonset the first one after P1.
///
/// Throws  Error  when the text is neither, the eclipse has no such contact, or the Moon does not rise or set there
almanac::Instant moment_from(const std::string& text, const eclipse::Eclipse& eclipse,
                             const MomentContext& context = {});

/// Eclipse of a day: greatest on that day in UTC, or on that day or in the night after it (until noon) in local time.
std::optional<eclipse::Eclipse> eclipse_of_day(const std::string& day,
                                               const MomentContext& context = {});

/// The same.
///
/// Throws  Error  when there is none: names the nearest
eclipse::Eclipse eclipse_on(const std::string& day, const MomentContext& context = {});

}  // namespace coppermoon::uses
