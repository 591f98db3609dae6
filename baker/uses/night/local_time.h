// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "almanac/instant.h"

namespace coppermoon::uses {

/// A moment on the clocks of a place.
struct LocalTime {
  std::string date;          ///< "2018-07-27"
  std::string time;          ///< "23:21:45"
  std::string abbreviation;  ///< of the zone then: "EAT", or "+03" where it has no name
};

/// A moment by the clocks of a time zone, rounded to the second: by that zone's rules for ever after the last
/// change that is known, and by local mean time before the first.
///
/// Given   zone   a name of the IANA's data, as "Africa/Nairobi", or an offset to the east of UTC: "+05:30"
/// Throws  Error  when the zone is neither, or the system has no zoneinfo
LocalTime local_time(const almanac::Instant& when, const std::string& zone);

/// The moment at which the clocks of a time zone show a time; the earlier of two, and of a time that clocks
/// leap over the moment of the leap.
///
/// Given   local  "2018-07-27T23:21:45"
///         zone   as above
/// Throws  Error  when the text is no such time; as local_time
almanac::Instant instant_of_local(const std::string& local, const std::string& zone);

}  // namespace coppermoon::uses
