// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"

namespace coppermoon::uses {

/// A moment in local time.
struct LocalTime {
  std::string date;          ///< such as "2018-07-27"
  std::string time;          ///< such as "23:21:45"
  std::string abbreviation;  ///< zone's name at that time, such as "EAT" or "+03"
};

/// Local time of a moment, rounded to the second. After the zone's last known transition, its last rule applies.
/// Before the first transition, local mean time is used.
///
/// Given   zone   a name from IANA's database, such as "Africa/Nairobi", or an offset east of UTC, such as "+05:30"
/// Throws  Error  when the zone is neither, or the system has no zoneinfo
LocalTime local_time(const almanac::Instant& when, const std::string& zone);

/// The moment at which clocks show a local time: the earlier one if they show it twice. If clocks skip the time, the
/// moment is that of the transition.
///
/// Given   local  such as "2018-07-27T23:21:45", in any form that almanac::instant_from_utc reads, without an offset
///         zone   as for local_time
/// Throws  Error  when `local` has another form, or when local_time does
almanac::Instant instant_of_local(const std::string& local, const std::string& zone,
                                  almanac::Calendar calendar = almanac::Calendar::gregorian);

/// Time zone of a place: the nearest city's or, if none is within 300 km, one for the longitude, such as "Etc/GMT+11",
/// which is 11 hours behind UTC.
std::string time_zone_of(const almanac::Observer& observer);

/// Like time_zone_of, but "+00:00" (UTC) if this system's zoneinfo lacks the zone.
std::string zone_or_utc(const almanac::Observer& observer);

/// Sentence that explains time_zone_of: "Local times are those of Hilo (Pacific/Honolulu), the nearest city that
/// is known, 120 km away."
std::string whose_clocks(const almanac::Observer& observer);

}  // namespace coppermoon::uses
