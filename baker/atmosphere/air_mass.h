// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Air mass: the amount of air along an observer's line of sight at sea level, divided by that towards the zenith.
///
///     M = (1.002432 c² + 0.148386 c + 0.0096467) / (c³ + 0.149864 c² + 0.0102963 c + 0.000303978)
///     c = cos z
///
/// Given     altitude  true (airless) altitude, 90° − z; -1 to 90 degrees
/// Returned  M         1 at the zenith, 31.7 at 0 degrees, 38.4 on the apparent horizon (-0.574
///                     degrees) and below it
/// Throws    Error     when the altitude is outside its range
/// Source    Young (1994), Appl. Opt. 33, 1108. Eq. 14 of Yapo & Cutler (2009) misprints 0.0102963
double air_mass_young_1994(algebra::Angle altitude);

/// Air mass of aerosol. It lies lower than the air itself, with a scale height of 1.5 km.
///
///     X = 1 / (c + 0.0123 exp(−24.5 c)),     c = sin a
///
/// Given     apparent_altitude  a, 0 to 90 degrees
/// Returned  X                  1 at the zenith, 81.3 on the horizon
/// Accuracy  3 % compared with the integral along a straight ray
/// Throws    Error              when the altitude is outside its range
/// Source    Schaefer (1993), Vistas in Astronomy 36, 311
double aerosol_air_mass_schaefer_1993(algebra::Angle apparent_altitude);

/// Air mass of ozone, which is assumed to be a thin layer 22 km above a sphere of radius R = 6378 km.
///
///     X = 1 / √(1 − (R cos a / (R + 22 km))²)
///
/// Given     apparent_altitude  a, 0 to 90 degrees
/// Returned  X                  1 at the zenith, 12.1 on the horizon
/// Throws    Error              when the altitude is outside its range
/// Source    Komhyr (1980), Operations handbook: ozone observations with a Dobson spectrophotometer,
///           WMO, §12
double ozone_air_mass(algebra::Angle apparent_altitude);

}  // namespace coppermoon::atmosphere
