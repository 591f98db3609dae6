// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "uses/night/circumstances.h"

namespace coppermoon::uses {

/// Calendar file (RFC 5545, times in UTC) with an event for an eclipse, and one for each contact seen from a place. The
/// eclipse's event begins at moonrise or when the Moon is first seen, and has an alarm one hour before. Events for the
/// same eclipse and place always have the same UIDs, so that a later file replaces them. UIDs differ between places.
///
/// Given   place_name  name such as "Honolulu", or coordinates
///         made        moment at which the file is made
/// Throws  Error       if no calendar file can hold the eclipse, or the place does not see it
std::string as_calendar(const Circumstances& night, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file with one event for each eclipse that is seen at least in part from a place. The event is the same as
/// the one for the whole eclipse in the calendar file for a single night.
///
/// Throws  Error  if require_in_calendars does
std::string as_calendar(const std::vector<Circumstances>& nights, const std::string& place_name,
                        const almanac::Instant& made);

/// Calendar file with one event for each eclipse, from P1 to P4, without a place.
///
/// Throws  Error  if require_in_calendars does
std::string as_calendar(const std::vector<eclipse::Eclipse>& eclipses,
                        const almanac::Instant& made);

/// Refuses eclipses that no calendar file can hold.
///
/// Throws  Error  if an eclipse is before the year 1, in which the dates of RFC 5545 begin, or if the list is empty,
///                because a calendar needs at least one event
void require_in_calendars(const std::vector<eclipse::Eclipse>& eclipses);

/// Refuses nights with eclipses that no calendar file can hold, or if the place sees none of the eclipses.
void require_in_calendars(const std::vector<Circumstances>& nights, const std::string& place_name);

}  // namespace coppermoon::uses
