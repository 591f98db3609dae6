// SPDX-License-Identifier: MIT
#pragma once

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// Air whose cloud and aerosol are scaled by one number, or increased in the stratosphere.
///
/// Given     clearness  1: no cloud, no aerosol; 0: the air unchanged; below 0: its amount is added to the optical
///                      depth of the stratosphere
/// Returned  air of belts, with all its columns changed
atmosphere::Atmosphere cleared(atmosphere::Atmosphere air, double clearness);

/// Interval in which clearness is searched for, and distance from its ends at which the search has failed.
inline constexpr double darkest_clearness = -2, brightest_clearness = 1,
                        clearness_error = 2. / 1024;

/// Clearness for which the eclipse nearest to a moment has the step L of Danjon's scale: at its greatest phase the Moon
/// has the visual magnitude that goes with L.
///
///     m = 4.2 − 3 L + (L/2)²
///
/// In an eclipse that is not total, the Moon is placed just inside the umbra.
///
/// Given     l    0 to 4
///           air  of belts, of that night
/// Returned  −2 to 1; at these ends the magnitude may be another
/// Accuracy  0.15 mag: the Moon is taken as even, its light by ten bands at a few places
/// Throws    Error  when l is outside its range
/// Source    H. C. Vital's correlation of observers' estimates (REA Brazil, 2004 to 2015); what the
///           air is cleared of is ours
double danjon_clearness(int l, const atmosphere::Atmosphere& air, const almanac::SkyState& sky);

}  // namespace coppermoon::uses
