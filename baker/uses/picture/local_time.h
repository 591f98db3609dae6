// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"

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
/// Given   local  "2018-07-27T23:21:45"
///         zone   as above
/// Throws  Error  for another text; as local_time
almanac::Instant instant_of_local(const std::string& local, const std::string& zone);

}  // namespace coppermoon::uses
