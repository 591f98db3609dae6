// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"

namespace coppermoon::eclipse {

/// Whether a text is a day alone, as "2018-07-27", "20180727" or "-0584-05-22".
bool is_day(std::string_view text);

/// Whether a text is a day and a time of day without an offset: "2018-07-27 20:21".
bool is_clock_time(std::string_view text);

/// Whether a text begins as a time of day, a contact, "moonrise" or "moonset" does.
bool is_contact_or_time(std::string_view text);

/// Whether a text begins as a date or a time of day does.
bool begins_with_digit(const std::string& text);

/// Whether a text is a day and a moment relative to a contact, moonrise or moonset.
bool is_from_contact(const std::string& text);

/// Whether a text is relative to moonrise or moonset.
bool is_from_horizon(const std::string& text);

/// Instant of a text relative to a contact of an eclipse, in letters of either case: "U2", "p1-10min",
/// "greatest + 90s".
///
/// Given   others  further moments that have names, as "moonrise"
/// Throws  Error   when the text is none, or the eclipse has no such contact
almanac::Instant moment_from(
    const std::string& text, const Eclipse& eclipse,
    const std::vector<std::pair<std::string, almanac::Instant>>& others = {});

}  // namespace coppermoon::eclipse
