// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Astronomical refraction: a celestial body's apparent altitude minus its true altitude.
///
///     R = 1.02' / tan(h + 10.3 / (h + 5.11)) + 0.0019'        h, 10.3 and 5.11 in degrees
///
/// Given     true_altitude  h, airless, -90 to 90 degrees
/// Returned  R              34.4' on the apparent horizon, 29.0' at h = 0, 5.4' at 10, 0 at 90
///                          degrees; below -1 degree, where the formula ends, R keeps its value at -1 degree
/// Accuracy  0.2' compared with printed tables from 2 degrees up; 1' on the horizon
/// Omits     weather and elevation (the formula is for 1010 hPa and 10 degrees Celsius, but actual refraction near the
///           horizon varies by several minutes of arc); colour (on the horizon, red and blue differ by 0.4')
/// Throws    Error          when the altitude is outside its range
/// Source    Saemundsson (1986), Sky & Telescope 72, 70; Meeus, Astronomical Algorithms, chapter 16, for the constant
///           0.0019', with which R vanishes at the zenith
algebra::Angle astronomical_refraction(algebra::Angle true_altitude);

/// True altitude of a body that appears on the sea horizon: h + R(h) = 0.
inline constexpr algebra::Angle lowest_true_altitude = algebra::degrees(-0.5739);

/// Apparent altitude: true altitude plus refraction. Refraction fades out from −1 to −2 degrees. Below −2 degrees,
/// where nothing can be seen, the true altitude is returned, as in almanacs.
///
/// Throws  Error  when the altitude is outside -90 to 90 degrees
algebra::Angle apparent_altitude(algebra::Angle true_altitude);

/// Ratio of height to width of a round disc seen through air: refraction lifts the lower limb more than the upper one.
///
///     k = 1 - (R(h - d/2) - R(h + d/2)) / d
///
/// Given     true_altitude  h, of the disc's centre, -90 to 90 degrees
///           diameter       d, 1e-6 to 10 degrees
/// Returned  k              0.83 for the Moon on the horizon, 0.87 half a degree above it, 0.9997 at
///                          the zenith
/// Omits     the stronger flattening of the lower half of the disc; the decrease in width by a factor of 1 - 3e-4
/// Throws    Error          when an argument is outside its range
/// Source    Meeus, Astronomical Algorithms, chapter 16
double refracted_flattening(algebra::Angle true_altitude, algebra::Angle diameter);

}  // namespace coppermoon::atmosphere
