// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "almanac/instant.h"

namespace coppermoon::uses {

/// Motions of Sun, Moon and Earth between two moments, as Chebyshev series in a time from −1 to 1. The frame is that of
/// eclipse::ShadowAxis, with its origin at the Earth's centre:
///
///     centre        the Moon's centre [km]
///     sunDistance   distance of the Sun [km], which is at 0, 0, −sunDistance
///     moonFrame     rotation from Moon-fixed axes, column by column
///     equatorFrame  rotation from the true equator and equinox of date
///
/// Also siderealTime [rad]: its value at Greenwich at time −1, and its increase up to time 1.
///
/// Given     from, to  an hour to a day apart
/// Returned  {"series": {name: [component][coefficient]}, "siderealTime": […], "seconds": …}
/// Accuracy  1 m, 1e-8 rad
nlohmann::ordered_json motion_between(const almanac::Instant& from, const almanac::Instant& to);

}  // namespace coppermoon::uses
