// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "uses/night/circumstances.h"

namespace coppermoon::uses {

/// Calendar file (RFC 5545, times in UTC) with an event for an eclipse, and one for each contact seen from a place. The
/// eclipse begins at moonrise or when the Moon is first seen, and has an alarm an hour before. Events for the same
/// eclipse and place always have the same UIDs, so that a later file replaces them. UIDs differ between places.
///
/// Given   place_name  name such as "Honolulu", or coordinates
///         made        moment at which the file is made
/// Throws  Error       as require_in_calendars
std::string as_calendar(const Circumstances& night, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file for those eclipses that a place sees at least in part. Each has one event, which is the same as that
/// for the whole eclipse in the calendar file for a single night.
///
/// Throws  Error  as require_in_calendars
std::string as_calendar(const std::vector<Circumstances>& nights, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file with one event for each eclipse, from P1 to P4, without a place.
///
/// Throws  Error  as require_in_calendars
std::string as_calendar(const std::vector<eclipse::Eclipse>& eclipses,
                        const almanac::Instant& made);

/// Refuses eclipses that no calendar file can hold.
///
/// Throws  Error  for an eclipse before year 1, when the dates of RFC 5545 begin; for an empty list, because a calendar
///                needs at least one event
void require_in_calendars(const std::vector<eclipse::Eclipse>& eclipses);

/// Refuses the eclipses of these nights in the same way, and also if the place sees none of them.
void require_in_calendars(const std::vector<Circumstances>& nights, const std::string& place_name);

}  // namespace coppermoon::uses
