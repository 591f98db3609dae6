// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "uses/light/photometer.h"
#include "uses/picture/moon.h"

namespace coppermoon::uses {

/// The whole Moon of one moment, above the air.
struct MoonBrightness {
  DiscBrightness disc;
  std::optional<double> danjon;  ///< of Danjon's scale, in totality alone
};

/// Planned, computed and summed up on a texture of 360 rows.
///
/// Throws  Error  as light_on_the_moon, normal_albedo
MoonBrightness brightness_of(const MoonRequest& moon, const almanac::SkyState& sky,
                             const algebra::Progress& progress = {});

}  // namespace coppermoon::uses
