// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "almanac/sky.h"
#include "texture/image.h"
#include "uses/light/moonlight.h"

namespace coppermoon::uses {

/// Earth's ring of sunsets, unrolled, as a place on the eclipsed Moon sees it.
struct RingStrip {
  /// linear Rec.709 [cd/m²]; columns: position angle on the sky about the Earth's centre, from celestial
  /// north through east; rows: even in the angle from that centre, the outer edge on top
  texture::Image light;
  /// orientation of strip and Earth on the sky, by name [degrees, km]
  std::vector<std::pair<std::string, double>> figures;
  texture::Attributes attributes;  ///< for a file's header
};

/// Given   request  only its air and its Sun are used
///         on       place on the Moon; none: the point with the Earth in the zenith
///         scale    factor of all values, 1e-9 to 1e9
/// Throws  Error    when no eclipse is under way, the Earth is below that place's horizon, direct
///                  sunlight falls there, or the air bends no light to it
RingStrip ring_strip(const LightRequest& request, const almanac::SkyState& sky,
                     const std::optional<almanac::SelenographicPoint>& on = {}, double scale = 1);

}  // namespace coppermoon::uses
