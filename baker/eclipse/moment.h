// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "almanac/instant.h"
#include "eclipse/contacts.h"

namespace coppermoon::eclipse {

/// A moment as text: an instant, "2018-07-27T18:24:00Z"; a day (UTC), "2018-07-27", which stands for its
/// greatest eclipse; or a day and a contact of that eclipse, "2018-07-27 U2+10min", "2018-07-27 greatest-90s".
///
/// Returned  rounded to the second for a day alone or a contact
/// Throws    Error  when the text is no moment; when the day has no eclipse: names the nearest eclipse
almanac::Instant moment_in(const std::string& text,
                           almanac::Calendar calendar = almanac::Calendar::gregorian);

/// Whether a text is a day alone, as "2018-07-27" or "-0584-05-22".
bool is_day(std::string_view text);

/// Whether a text begins as a time of day or a contact does.
bool is_contact_or_time(std::string_view text);

/// Whether a text begins as a date or a time of day does.
bool begins_with_digit(const std::string& text);

/// Whether a text gives a moment relative to a contact.
bool is_from_contact(const std::string& text);

/// Instant of a text that is an instant or relative to a contact of an eclipse: "U2", "P1-10min", "greatest+90s".
///
/// Throws  Error  when the text is neither, or the eclipse has no such contact
almanac::Instant moment_from(const std::string& text, const Eclipse& eclipse,
                             almanac::Calendar calendar = almanac::Calendar::gregorian);

/// The eclipse that is greatest on a day (UTC).
///
/// Throws  Error  when there is none: names the nearest
Eclipse eclipse_on(const std::string& day,
                   almanac::Calendar calendar = almanac::Calendar::gregorian);

}  // namespace coppermoon::eclipse
