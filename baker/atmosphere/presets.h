// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "atmosphere/atmosphere.h"

namespace coppermoon::atmosphere {

/// The named atmospheres:
///
///     paper      sphere; US 1976 to 42 km; CRC dispersion, F = 1.050; 345 DU of ozone as a filter
///     molecular  ellipsoid; US 1976 to 86 km; Ciddor's dispersion, Bates's F(λ); nothing else
///     clear      molecular, and 345 DU of ozone along the path
///     standard   clear, and what is usual: background stratosphere, tropospheric aerosol of 0.07,
///                cloud to 10 km over 70 % of the limb
///     none       the bare Earth, an ellipsoid
std::span<const std::string_view> preset_names();

/// Given   sun_declination  tips the ellipsoid's pole
/// Throws  Error            when there is no preset of that name: says which there are
Atmosphere preset(std::string_view name, algebra::Angle sun_declination);

/// What cloud and aerosol make a totally eclipsed Moon look as Danjon's scale describes it.
///
///     L  cloud cover  tropospheric optical depth  stratosphere            what it looks like
///
/// Given     l  0 (very dark, almost invisible) to 4 (bright copper)
/// Returned  the column with its cloud and aerosol replaced
/// Throws    Error  when l is outside its range
Column danjon(int l, Column column);

}  // namespace coppermoon::atmosphere
