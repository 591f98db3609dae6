// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Luminance [cd/m²] of a surface brightness in V magnitudes per square arc second.
///
///     1.08e5 · 10^(−0.4 m)
///
/// Given   mag_per_arcsec2  0 to 30
/// Throws  Error            when the brightness is outside its range
/// Source  the literature's factor 1.08e5; the Sun's V = -26.76 and 1.28e5 lx confirm it to 3 %
double luminance_of_magnitude_cd_m2(double mag_per_arcsec2);

/// Luminance of a clear sky, added to everything seen through it: twilight, and the airglow of a moonless
/// night, 21.9 mag/arcsec².
///
///     0.6 · 10^(a + b x + c x² + d x³) / π      x: the Sun's altitude over 90 degrees
///
/// Given     sun_altitude  of the Sun's centre, airless; -90 to 5 degrees
/// Returned  [cd/m²] at the zenith, 0.6 of the sky's mean: 145 with the Sun on the horizon, 1.9e-4 at night
/// Accuracy  a factor of two across the sky
/// Omits     the light of Moon and towns, zodiacal light; the sky's colour
/// Throws    Error         when the Sun's altitude is outside its range
/// Source    illuminance: Janiczek & DeYoung (1987), USNO Circular 171; zenith: Patat, Ugolnikov &
///           Postylyakov (2006), A&A 455, 385; night: Patat (2003), A&A 400, 1183
double sky_luminance_cd_m2(algebra::Angle sun_altitude);

}  // namespace coppermoon::atmosphere
