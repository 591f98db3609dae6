// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"

namespace coppermoon::eclipse {

/// Whether a string is a day alone, such as "2018-07-27", "20180727" or "-0584-05-22".
bool is_day(std::string_view text);

/// Whether a string is a day and a time of day without a UTC offset, such as "2018-07-27 20:21".
bool is_clock_time(std::string_view text);

/// Whether a string begins with a time of day, a contact, "moonrise" or "moonset".
bool is_contact_or_time(std::string_view text);

/// Whether a string begins with a digit, possibly after a minus sign, like a date or a time of day.
bool begins_with_digit(const std::string& text);

/// Whether a string is a day and a moment relative to a contact, moonrise or moonset: "2018-07-27 U2-10min".
bool is_from_contact(const std::string& text);

/// Whether a string gives a moment relative to moonrise or moonset, such as "moonrise+1h".
bool is_from_horizon(const std::string& text);

/// Reads a moment that is given relative to a contact of an eclipse, in upper or lower case: "U2", "p1-10min",
/// "greatest + 90s".
///
/// Given   others  further named moments, such as "moonrise"
/// Throws  Error   if the text is not such a moment, or the eclipse does not have the contact
almanac::Instant moment_from(
    const std::string& text, const Eclipse& eclipse,
    const std::vector<std::pair<std::string, almanac::Instant>>& others = {});

}  // namespace coppermoon::eclipse
