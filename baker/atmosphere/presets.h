// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "atmosphere/atmosphere.h"

namespace coppermoon::atmosphere {

/// Names of the presets:
///
///     paper      sphere; US 1976 to 42 km; CRC dispersion; King factor F = 1.050; 345 DU of ozone as a filter
///     molecular  ellipsoid; US 1976 to 86 km; Ciddor's dispersion; Bates's King factor F(λ); nothing else
///     clear      like molecular, with 345 DU of ozone along the path of each ray
///     undated    like clear, with average aerosol and cloud, independent of place and date: background stratosphere,
///                tropospheric optical depth of 0.07, cloud up to 10 km over 70 % of the limb
///     standard   air of a month in 13 belts of latitude (see climatic), with a tropospheric optical depth of 0.07,
///                cloud and cirrus by probability, absorption by oxygen, nitrogen dioxide and water vapour
///     calibrated like standard, with the probability of cloud multiplied by 0.60. This factor was fitted to
///                measurements of the whole Moon in five eclipses and of the umbra in a sixth. When an eclipse is
///                left out of the fit, its predicted brightness is off by 0.21 mag rms ("standard": 0.25 mag)
///     none       the Earth without air, an ellipsoid
std::span<const std::string_view> preset_names();

/// Atmosphere of the preset with the given name.
///
/// Given   sun_declination  angle by which the ellipsoid's north pole is tipped towards the Sun
///         year             with a fractional part; only "standard" and "calibrated" depend on it
/// Throws  Error            when there is no preset of this name; the message lists the names
Atmosphere preset(std::string_view name, algebra::Angle sun_declination, double year = 2000);

/// Sets everything in a column that depends on latitude and month: density, ozone, stratospheric aerosol, tropopause,
/// free-tropospheric aerosol, probability of cloud, and water vapour.
///
/// Given  year  its fractional part determines the month
Column climatic(Column column, algebra::Angle latitude, double year);

/// Thirteen belts with the same column, 15° of position angle apart. In a month's climatological air, the light differs
/// from a calculation with 25 belts by 0.7 % rms, 3 % at most.
Belts belts_of(const Column& column);

/// Latitude of the limb at an angle θ from north, where δ is the Sun's declination.
///
///     sin φ = cos θ cos δ
algebra::Angle latitude_on_limb(double from_north_rad, algebra::Angle sun_declination);

/// Column with the cloud and aerosol of an eclipse of brightness L on Danjon's scale:
///
///     L   looks                        troposphere, cloud    stratosphere   dust layer
///     0   almost invisible             as usual              extreme        1e-6 m⁻¹, 15 to 25 km
///     1   dark, grey-brown             as usual              high           none
///     2   dark red, rust               as usual              moderate       3e-6 m⁻¹, 15 to 20 km
///     3   brick red                    as usual              background     none
///     4   bright copper, bluish rim    neither               none           none
///
/// "as usual" means an aerosol optical depth of 0.07, and cloud up to 10 km over 70 % of the limb.
///
/// Given     l       L, 0 to 4
///           column  column whose cloud, aerosol and dust are replaced
/// Accuracy  0.5 mag for the eclipse of 21 February 2008, compared with m = 4.2 − 3 L + (L/2)²
/// Throws    Error  when l is outside its range
/// Source    H. C. Vital's correlation of magnitude with L (REA Brazil, 2004 to 2015); the aerosol for each L is the
///           project's own choice
Column danjon(int l, Column column);

}  // namespace coppermoon::atmosphere
