// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "uses/light/photometer.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Brightness of the whole Moon at a place on the Earth, through its air.
struct BrightnessSeen {
  povray_scenes::HorizonPlace moon;    ///< refraction included
  DiscBrightness disc;                 ///< through the air
  std::vector<double> extinction_mag;  ///< [band]; 0 without reddening
};

/// Brightness of the whole Moon at one moment.
struct MoonBrightness {
  DiscBrightness disc;           ///< above the air, from the Earth's centre
  std::optional<double> danjon;  ///< of Danjon's scale, in totality alone
  /// standard error of the V magnitude, in totality and the air of a month alone (totality_error_mag)
  std::optional<double> V_error = {};
  std::optional<BrightnessSeen> seen = {};
};

/// Standard error of the V magnitude of a totally eclipsed Moon in the air of its month [mag].
///
///     σ² = (0.23 mag)² + (50 mag δτ)²       δτ: error of the stratosphere's optical depth
///
/// 0.23 is what is left of five eclipses that instruments measured, weather included; 50 is how a total eclipse darkens
/// with that optical depth: 40 to 58 in eclipses of umbral magnitudes 1.01 to 1.61.
///
/// Given     year  with its fraction
/// Returned  nothing where the air is not that of its month, as it is known ("standard" or "calibrated" as they stand)
/// Accuracy  6 of 9 measured and observed eclipses lie within it and the observers' own 0.3 mag; 68 of 100 would
std::optional<double> totality_error_mag(const Air& air, double year);

/// Magnitudes of the whole Moon above the air, from the Earth's centre, [band].
///
/// Accuracy  0.003 mag, of a disc of 180 rows
std::vector<double> magnitudes_above(const LitMoon& moon);

/// Brightness by a simulation, summed over a texture of 360 rows.
///
/// Given   view   for its observer and air
/// Omits   the horizon, and flattening of the disc
/// Throws  Error  as light_on_the_moon, normal_albedo, view_of
MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const ViewRequest& view = {}, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
