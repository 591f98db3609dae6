// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "almanac/instant.h"

namespace coppermoon::uses {

/// How Sun, Moon and Earth move between two moments, as sums of Chebyshev polynomials of a time that runs
/// from −1 to 1. In the frame of eclipse::ShadowAxis, origin at the Earth's centre:
///
///     centre        the Moon's centre [km]
///     sunDistance   [km]; the Sun is at 0, 0, −sunDistance
///     moonFrame     what turns Moon-fixed axes into the shadow's, column by column
///     equatorFrame  the same for the true equator and equinox of date
///
/// and siderealTime [rad], sidereal time at Greenwich when the time is −1, and how much it grows until 1.
///
/// Given     from, to  an hour to a day apart
/// Returned  {"series": {name: [component][coefficient]}, "siderealTime": […], "seconds": …}
/// Accuracy  1 m, 1e-8 rad
nlohmann::ordered_json motion_between(const almanac::Instant& from, const almanac::Instant& to);

}  // namespace coppermoon::uses
