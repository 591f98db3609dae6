// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "uses/light/photometer.h"
#include "uses/picture/moon.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// The whole Moon as a place on the Earth sees it, at its distance and through its air.
struct BrightnessSeen {
  povray_scenes::HorizonPlace moon;    ///< refraction counted
  DiscBrightness disc;                 ///< through the air
  std::vector<double> extinction_mag;  ///< [band], by which the air dims; 0 without reddening
};

/// The whole Moon of one moment.
struct MoonBrightness {
  DiscBrightness disc;           ///< above the air, from the Earth's centre
  std::optional<double> danjon;  ///< of Danjon's scale, in totality alone
  std::optional<BrightnessSeen> seen = {};
};

/// Planned, computed and summed up on a texture of 360 rows.
///
/// Given   view   of which the observer and the air above are asked for
/// Omits   what the horizon and refraction do to the disc's outline
/// Throws  Error  as light_on_the_moon, normal_albedo, view_of
MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const ViewRequest& view = {}, const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
