// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "uses/night/circumstances.h"

namespace coppermoon::uses {

/// Calendar file (RFC 5545, times in UTC) for an eclipse and those of its contacts that are seen from a place. The
/// eclipse begins at moonrise or at the first moment seen, with an alarm an hour before. Events for the same eclipse
/// and place keep their UIDs, so that a later file replaces them; events for another place have different UIDs.
///
/// Given   place_name  "Honolulu", or coordinates
///         made        when the file is made
/// Throws  Error       as require_in_calendars
std::string as_calendar(const Circumstances& night, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file for the eclipses that a place sees at least in part. Each has one event, the same as the one for the
/// whole eclipse in a night's file.
///
/// Throws  Error  as require_in_calendars
std::string as_calendar(const std::vector<Circumstances>& nights, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file for eclipses from P1 to P4, without a place.
///
/// Throws  Error  as require_in_calendars
std::string as_calendar(const std::vector<eclipse::Eclipse>& eclipses,
                        const almanac::Instant& made);

/// Refuses eclipses that no calendar file can hold.
///
/// Throws  Error  for an eclipse before year 1, when the dates of RFC 5545 begin; for an empty list, because a calendar
///                needs at least one event
void require_in_calendars(const std::vector<eclipse::Eclipse>& eclipses);

/// Throws  Error  also when the place sees none of these eclipses
void require_in_calendars(const std::vector<Circumstances>& nights, const std::string& place_name);

}  // namespace coppermoon::uses
