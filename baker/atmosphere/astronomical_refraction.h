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
///                          degrees; below -1 degree, where the formula ends, the value at -1 degree
/// Accuracy  0.2' against printed tables from 2 degrees up; 1' on the horizon
/// Omits     weather and elevation: the air is at 1010 hPa and 10 degrees Celsius, but actual refraction near the
///           horizon varies by several minutes of arc; colour, which makes 0.4' between red and blue on the horizon
/// Throws    Error          when the altitude is outside its range
/// Source    Saemundsson (1986), Sky & Telescope 72, 70; the constant that makes it vanish at the zenith:
///           Meeus, Astronomical Algorithms, chapter 16
algebra::Angle astronomical_refraction(algebra::Angle true_altitude);

/// True altitude of a body that appears on the sea horizon: h + R(h) = 0.
inline constexpr algebra::Angle lowest_true_altitude = algebra::degrees(-0.5739);

/// Apparent altitude: true altitude plus refraction. From −1 to −2 degrees refraction fades out; below −2
/// degrees, where nothing is seen, the true altitude is returned, as almanacs print it.
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
/// Omits     the difference between the flatter lower half and the upper half; a shrinkage of the width by 3e-4
/// Throws    Error          when an argument is outside its range
/// Source    Meeus, Astronomical Algorithms, chapter 16
double refracted_flattening(algebra::Angle true_altitude, algebra::Angle diameter);

}  // namespace coppermoon::atmosphere
