// SPDX-License-Identifier: MIT
#pragma once

#include "almanac/sky.h"
#include "atmosphere/atmosphere.h"

namespace coppermoon::uses {

/// Air with all that dims it multiplied by one number, or with more in the stratosphere.
///
/// Given     clearness  1: no cloud, no aerosol; 0: the air as it is; below 0: as much is added to the
///                      stratosphere's optical depth
/// Returned  the air, of belts, with all its columns changed so
atmosphere::Atmosphere cleared(atmosphere::Atmosphere air, double clearness);

/// The ends between which clearness is sought; how near to them it is where none does.
inline constexpr double darkest_clearness = -2, brightest_clearness = 1, clearness_error = 2. / 1024;

/// The clearness that makes the eclipse nearest to that moment one of Danjon's scale: its Moon, at the
/// greatest phase, of the visual magnitude that goes with L.
///
///     m = 4.2 − 3 L + (L/2)²
///
/// An eclipse that is not total is taken as if the Moon had just gone in.
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
