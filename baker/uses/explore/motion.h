// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "almanac/instant.h"

namespace coppermoon::uses {

/// Motions of the Sun, the Moon and the Earth between two moments, as Chebyshev series in a time from −1 to 1.
/// Positions are in the frame of eclipse::ShadowAxis, with the origin at the Earth's centre:
///
///     centre        position of the Moon's centre [km]
///     sunDistance   distance of the Sun [km], whose position is (0, 0, −sunDistance)
///     moonFrame     rotation matrix from Moon-fixed axes, column by column
///     equatorFrame  rotation matrix from the true equator and equinox of date, column by column
///
/// In addition, siderealTime [rad] holds Greenwich sidereal time at the first moment and its increase until the second.
///
/// Given     from, to  between an hour and a day apart
/// Returned  {"series": {name: [component][coefficient]}, "siderealTime": […], "seconds": …}
/// Accuracy  1 m, 1e-8 rad
nlohmann::ordered_json motion_between(const almanac::Instant& from, const almanac::Instant& to);

}  // namespace coppermoon::uses
