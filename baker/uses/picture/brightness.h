// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "uses/light/photometer.h"
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
  std::optional<BrightnessSeen> seen = {};
};

/// Brightness by a simulation, summed over a texture of 360 rows.
///
/// Given   view   for its observer and air
/// Omits   the horizon, and flattening of the disc
/// Throws  Error  as light_on_the_moon, normal_albedo, view_of
MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const ViewRequest& view = {}, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
