// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "algebra/described.h"
#include "almanac/ephemeris.h"
#include "almanac/instant.h"
#include "almanac/lunar_orientation.h"
#include "eclipse/contacts.h"

namespace coppermoon::eclipse {

/// Times at which the umbra's edge reaches and leaves a place on the Moon; both are empty if the umbra misses it.
struct FeatureTimes {
  std::optional<almanac::Instant> immersion, emersion;
};

template <class Field>
void describe_times(Field&& is, const FeatureTimes& times) {
  is("immersion", algebra::if_any(times.immersion), "moment at which the umbra's edge reaches it");
  is("emersion", algebra::if_any(times.emersion), "moment at which the umbra's edge leaves it");
}

/// Times at which the umbra's edge crosses a lunar feature, always with ShadowConvention::danjon_oblate. Times are also
/// given for places on the far side, which cannot be seen.
///
/// Given     place     latitude −90° to 90°, longitude −360° to 360°
/// Accuracy  compared with 16 times of the eclipse of 3 March 2007, published to the minute: 32 s at worst, mean 14 s
/// Omits     the height of the ground above the mean sphere; 3 km at the disc's edge would change a time by 3 s
/// Throws    Error  if the place is out of range
/// Source    crater timings by Espenak, NASA Eclipse Home Page
FeatureTimes feature_times(const Eclipse& eclipse, const almanac::SelenographicPoint& place,
                           almanac::LunarTheory theory = almanac::LunarTheory::elp_2000_82b);

}  // namespace coppermoon::eclipse
