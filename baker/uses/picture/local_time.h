// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"
#include "almanac/observer.h"

namespace coppermoon::uses {

/// Local time of a moment.
struct LocalTime {
  std::string date;          ///< "2018-07-27"
  std::string time;          ///< "23:21:45"
  std::string abbreviation;  ///< of the zone then: "EAT", or "+03" where it has no name
};

/// Local time of a moment, rounded to the second. After the last known transition the zone's last rule goes on; before
/// the first, local mean time holds.
///
/// Given   zone   a name of the IANA's data, as "Africa/Nairobi", or an offset to the east of UTC: "+05:30"
/// Throws  Error  when the zone is neither, or the system has no zoneinfo
LocalTime local_time(const almanac::Instant& when, const std::string& zone);

/// Moment of a local time: the earlier one where a time comes twice, the transition where a time is skipped.
///
/// Given   local  "2018-07-27T23:21:45", in any spelling of almanac::instant_from_utc without an offset
///         zone   as above
/// Throws  Error  for another text; as local_time
almanac::Instant instant_of_local(const std::string& local, const std::string& zone,
                                  almanac::Calendar calendar = almanac::Calendar::gregorian);

/// Time zone of a place: that of the nearest city, or, where none is within 300 km, that of the longitude, as
/// "Etc/GMT+11": 11 hours behind UTC.
std::string time_zone_of(const almanac::Observer& observer);

/// The same; UTC, as "+00:00", where this system's zoneinfo lacks it.
std::string zone_or_utc(const almanac::Observer& observer);

/// Sentence about the origin of time_zone_of: "Local times are those of Hilo (Pacific/Honolulu), the nearest city that
/// is known, 120 km away."
std::string whose_clocks(const almanac::Observer& observer);

}  // namespace coppermoon::uses
