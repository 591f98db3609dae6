// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "almanac/instant.h"
#include "almanac/observer.h"

namespace coppermoon::uses {

/// Moonrise or moonset.
struct Crossing {
  almanac::Instant when;
  bool rises;
};

/// Moonrises and moonsets of a place between two moments, in order of time: zeros of above_horizon, which has parallax.
///
/// Accuracy  0.1 s, by the Moon's place; weather changes refraction, and so the time by a minute or more
/// Throws    Error  as require_on_earth
std::vector<Crossing> horizon_crossings(const almanac::Observer& place,
                                        const almanac::Instant& from, const almanac::Instant& to);

}  // namespace coppermoon::uses
