// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <string_view>
#include <vector>

#include "algebra/quantity.h"
#include "almanac/instant.h"

namespace coppermoon::almanac {

/// A planet as seen from the Earth's centre.
struct Planet {
  std::string_view name;
  glm::dvec3 position_m;  ///< apparent position (light time, aberration) in GCRS axes [m]
  double magnitude;       ///< magnitude in the V band
  double b_minus_v;
  algebra::Length radius;  ///< equatorial radius
};

/// The planets from Mercury to Neptune, without the Earth.
///
/// Accuracy  positions: 1″ from 1800 to 2100 (VSOP87's authors), 0.15″ in Meeus's example for 1992; magnitudes: 0.1
/// Omits     changes in magnitude with the rotation and seasons of Mars, and with Uranus's sub-Earth latitude (0.1 mag)
/// Source    VSOP87 (Bretagnon & Francou 1988, Astron. Astrophys. 202, 309) in libnova;
///           magnitudes: Mallama & Hilton (2018), Astronomy and Computing 25, 10; B − V: Cox (2000),
///           Allen's Astrophysical Quantities; radii: Archinal et al. (2018), Celest. Mech. 130, 22
std::vector<Planet> planets_at(const Instant& instant);

}  // namespace coppermoon::almanac
