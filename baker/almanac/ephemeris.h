// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "almanac/instant.h"

namespace coppermoon::almanac {

inline constexpr double astronomical_unit_m = 149597870700.0, speed_of_light_m_per_s = 299792458.0;

/// Theories of the Moon's motion: ERFA's short `moon98`, or libnova's full `elp_2000_82b`.
///
/// moon98        3 µs a call; accurate to 2.9″ RMS, and 18″ at worst, from 1950 to 2100
/// elp_2000_82b  2 to 4 ms a call, one call at a time in the whole process (libnova keeps static state).
///               The Moon's mean longitude is corrected to agree with DE405 by
///                   −0.07008″ − 0.35106″ T − 0.95753″ T²          T in centuries from 2000
///               of which −0.9201″ T², or 23″ in 1500 and 1500″ in −1999, is due to a newer value of tidal acceleration
/// Source  Meeus (1998), Astronomical Algorithms, chapter 47, as implemented in ERFA;
///         Chapront-Touzé & Chapront (1983), Astron. Astrophys. 124, 50;
///         for the correction, Chapront & Francou (2003), Astron. Astrophys. 404, 735 (ELP/MPP02)
enum class LunarTheory { moon98, elp_2000_82b };

/// Apparent geocentric position of the Sun, with light time and aberration.
///
/// Returned  vector from the Earth's centre in GCRS axes [m]
/// Accuracy  0.1″ from 1800 to 2100; compared with VSOP87, 0.5″ in 1000 and 3000, 4″ in year 0 and 28″ in −1999
/// Source    ERFA eraEpv00 (shortened VSOP2000)
glm::dvec3 apparent_sun_m(const Instant& instant);

/// Apparent geocentric position of the Moon. The correction for light time ignores the Earth's own motion during that
/// time, because aberration cancels its effect.
///
/// Returned  vector from the Earth's centre in GCRS axes [m]
glm::dvec3 apparent_moon_m(const Instant& instant, LunarTheory theory);

}  // namespace coppermoon::almanac
