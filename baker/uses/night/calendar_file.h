// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "uses/night/circumstances.h"

namespace coppermoon::uses {

/// Calendar file, RFC 5545 with times in UTC, of an eclipse and those of its contacts that a place sees. The eclipse
/// begins with moonrise or what is first seen, and an hour before there is an alarm. Events of the same eclipse and place
/// keep their UIDs, so that a later file replaces them; another place's events have others.
///
/// Given   place_name  "Honolulu", or coordinates
///         made        time of the file
/// Throws  Error       as require_in_calendars
std::string as_calendar(const Circumstances& night, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file of the eclipses of which a place sees something, an event each: those of the whole eclipse in the file of
/// a night.
///
/// Throws  Error  as require_in_calendars
std::string as_calendar(const std::vector<Circumstances>& nights, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file of eclipses without a place, from P1 to P4.
///
/// Throws  Error  as require_in_calendars
std::string as_calendar(const std::vector<eclipse::Eclipse>& eclipses,
                        const almanac::Instant& made);

/// Refuses what no calendar file holds.
///
/// Throws  Error  for an eclipse before year 1, where the dates of RFC 5545 begin, and for no eclipse, as a calendar has
///                an event at least
void require_in_calendars(const std::vector<eclipse::Eclipse>& eclipses);

/// Throws  Error  and where nothing of these eclipses is seen
void require_in_calendars(const std::vector<Circumstances>& nights, const std::string& place_name);

}  // namespace coppermoon::uses
