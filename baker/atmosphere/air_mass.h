// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::atmosphere {

/// Air between an observer at sea level and a light in the sky, over that towards the zenith.
///
///     M = (1.002432 c² + 0.148386 c + 0.0096467) / (c³ + 0.149864 c² + 0.0102963 c + 0.000303978)
///     c = cos z
///
/// Given     altitude  of the light above the horizon without refraction, 90° − z; 0 to 90 degrees
/// Returned  M         1 at the zenith, 31.7 at the horizon
/// Throws    Error     when the altitude is outside its range
/// Source    Young (1994), Appl. Opt. 33, 1108. Eq. 14 of Yapo & Cutler (2009) misprints 0.0102963
double air_mass_young_1994(algebra::Angle altitude);

}  // namespace coppermoon::atmosphere
