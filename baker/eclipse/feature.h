// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/described.h"
#include "almanac/ephemeris.h"
#include "almanac/instant.h"
#include "almanac/lunar_orientation.h"
#include "eclipse/contacts.h"

namespace coppermoon::eclipse {

/// Times at which the umbra's edge reaches and leaves a place on the Moon; both empty where it does not reach it.
struct FeatureTimes {
  std::optional<almanac::Instant> immersion, emersion;
};

template <class Field>
void describe_times(Field&& is, const FeatureTimes& times) {
  is("immersion", algebra::if_any(times.immersion), "moment at which the umbra's edge reaches it");
  is("emersion", algebra::if_any(times.emersion), "moment at which the umbra's edge leaves it");
}

/// Times of the umbra's edge at a lunar feature, always by ShadowConvention::danjon_oblate. Places on the far side,
/// which are not seen, have their times, too.
///
/// Given     place     latitude −90° to 90°, longitude −360° to 360°
/// Accuracy  against the 16 published times of 3 March 2007 (to the minute): 32 s worst, 14 s on
///           average
/// Omits     the height of the ground over the mean sphere: 3 km at the disc's edge is 3 s
/// Throws    Error  when the place is outside its range
/// Source    the craters' timings of Espenak, NASA Eclipse Home Page
FeatureTimes feature_times(const Eclipse& eclipse, const almanac::SelenographicPoint& place,
                           almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

}  // namespace coppermoon::eclipse
