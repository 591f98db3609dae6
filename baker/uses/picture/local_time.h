// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"

namespace coppermoon::uses {

/// A moment in local time.
struct LocalTime {
  std::string date;          ///< "2018-07-27"
  std::string time;          ///< "23:21:45"
  std::string abbreviation;  ///< for the zone at that time: "EAT", or "+03" if it has no name
};

/// Local time of a moment, rounded to the second. After the last known transition the zone's last rule continues;
/// before the first, local mean time holds.
///
/// Given   zone   a name from IANA's database, such as "Africa/Nairobi", or an offset east of UTC, such as "+05:30"
/// Throws  Error  when the zone is neither, or the system has no zoneinfo
LocalTime local_time(const almanac::Instant& when, const std::string& zone);

/// The moment of a local time: the earlier one if the time occurs twice, the transition if it is skipped.
///
/// Given   local  "2018-07-27T23:21:45", in any spelling of almanac::instant_from_utc without an offset
///         zone   as above
/// Throws  Error  for any other text; as local_time
almanac::Instant instant_of_local(const std::string& local, const std::string& zone,
                                  almanac::Calendar calendar = almanac::Calendar::gregorian);

/// Time zone of a place: the nearest city's or, if none is within 300 km, one by longitude such as "Etc/GMT+11",
/// which is 11 hours behind UTC.
std::string time_zone_of(const almanac::Observer& observer);

/// The same, but UTC as "+00:00" if this system's zoneinfo lacks the zone.
std::string zone_or_utc(const almanac::Observer& observer);

/// Sentence that explains time_zone_of: "Local times are those of Hilo (Pacific/Honolulu), the nearest city that
/// is known, 120 km away."
std::string whose_clocks(const almanac::Observer& observer);

}  // namespace coppermoon::uses
