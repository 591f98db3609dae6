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
///     undated    clear, and what is usual, alike everywhere and always: background stratosphere,
///                tropospheric aerosol of 0.07, cloud to 10 km over 70 % of the limb
///     standard   the air of a month along the limb, in 13 belts: see climatic; with tropospheric aerosol
///                of 0.07, cloud and cirrus by chance, pairs of oxygen and nitrogen dioxide
///     calibrated standard, with a chance of cloud of 0.63 times as much: one number, fitted to the whole Moon of five
///                eclipses and the umbra of a sixth as instruments measured them (calibration.cpp). Each left out in
///                turn, it foretells them to 0.21 mag rms, "standard" to 0.25
///     none       the bare Earth, an ellipsoid
std::span<const std::string_view> preset_names();

/// Given   sun_declination  tips the ellipsoid's pole
///         year             with its fraction, of "standard" and "calibrated"
/// Throws  Error            when there is no preset of that name: says which there are
Atmosphere preset(std::string_view name, algebra::Angle sun_declination, double year = 2000);

/// A column with all that depends on latitude and month: density, ozone, the stratosphere's aerosol,
/// the tropopause, the free troposphere's aerosol, cloud by chance.
///
/// Given     year  with its fraction
/// Returned  the column with these replaced
Column climatic(Column column, algebra::Angle latitude, double year);

/// Thirteen belts of one column, 15° of position angle apart. In the air of a month light is 0.7 % rms off
/// that of twice as many, 3 % at worst.
Belts belts_of(const Column& column);

/// The latitude of a belt on the limb.
///
///     sin φ = cos θ cos δ
algebra::Angle latitude_on_limb(double from_north_rad, algebra::Angle sun_declination);

/// A column with the cloud and aerosol that make a totally eclipsed Moon look as Danjon's scale
/// describes it:
///
///     L   looks                        troposphere, cloud    stratosphere   dust layer
///     0   almost invisible             as usual              extreme        1e-6 m⁻¹, 15 to 25 km
///     1   dark, grey-brown             as usual              high           none
///     2   dark red, rust               as usual              moderate       3e-6 m⁻¹, 15 to 20 km
///     3   brick red                    as usual              background     none
///     4   bright copper, bluish rim    neither               none           none
///
/// "as usual" means: aerosol of 0.07, cloud to 10 km over 70 % of the limb.
///
/// Given     l  0 to 4
/// Returned  the column with its cloud, aerosol and dust replaced
/// Accuracy  0.5 mag of the eclipse of 21 February 2008, against m = 4.2 − 3 L + (L/2)²
/// Throws    Error  when l is outside its range
/// Source    H. C. Vital's correlation of magnitude with L (REA Brazil, 2004 to 2015); the aerosol
///           that goes with each L is ours
Column danjon(int l, Column column);

}  // namespace coppermoon::atmosphere
