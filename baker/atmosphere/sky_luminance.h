// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Luminance [cd/m²] of a surface brightness in V magnitudes for each square arc second.
///
///     1.08e5 · 10^(−0.4 m)
///
/// Given   mag_per_arcsec2  0 to 30
/// Throws  Error            outside its range
/// Source  the Sun's V = -26.76 and 1.28e5 lx, within 3 % of the literature's 1.08e5
double luminance_of_magnitude_cd_m2(double mag_per_arcsec2);

/// Luminance of a clear sky's own light, which adds to all that is seen through it: twilight, and
/// the airglow of a moonless night, 21.9 mag/arcsec².
///
///     0.6 · 10^(a + b x + c x² + d x³) / π      x: the Sun's altitude over 90 degrees
///
/// Given     sun_altitude  of its centre, airless; -90 to 5 degrees
/// Returned  [cd/m²] at the zenith, 0.6 of the sky's mean: 145 with the Sun in the horizon, 1.9e-4 by
///           night
/// Accuracy  a factor of two, by where in the sky
/// Omits     the light of Moon and towns, zodiacal light; a sky's own colour
/// Throws    Error         when it is outside its range
/// Source    illuminance: Janiczek & DeYoung (1987), USNO Circular 171; zenith: Patat, Ugolnikov &
///           Postylyakov (2006), A&A 455, 385; night: Patat (2003), A&A 400, 1183
double sky_luminance_cd_m2(algebra::Angle sun_altitude);

}  // namespace coppermoon::atmosphere
