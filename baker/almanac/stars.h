// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "almanac/instant.h"

namespace coppermoon::almanac {

/// A fixed star.
struct Star {
  glm::dvec3 place;                     ///< unit vector, epoch 2000.0, in ICRS axes
  double magnitude, b_minus_v;          ///< V magnitude; B − V
  glm::dvec3 motion_per_year{0, 0, 0};  ///< proper motion, perpendicular to `place` [radians]
};

/// Stars down to V = 9.0 within 10 degrees of the ecliptic, where the Moon can be, and down to V = 6.5 elsewhere.
///
/// Accuracy  compared with Hipparcos, 0.02″ in position, 0.05 in magnitude and 0.03 in B − V. A few stars, such as
///           Alcyone, are off by 0.4″ because Stellarium's catalogue gives their positions at epoch 1991.25
/// Omits     proper motion of stars that Hipparcos did not measure (one star in four, mostly fainter than V = 8)
/// Source    Hipparcos (ESA 1997), Tycho-2 (Høg et al. 2000) and NOMAD 1 (U.S. Naval Observatory), as
///           selected and rounded by baker/almanac/data/make_stars.py
const std::vector<Star>& stars();

/// Apparent directions of stars from the Earth's centre, with proper motion and aberration.
///
/// Returned  unit vectors in GCRS axes, in the order of the stars
/// Accuracy  0.01″ compared with ERFA, within 1000 years of 2000
/// Omits     parallax; deflection by the Sun's gravity, which matters only near the Sun
std::vector<glm::dvec3> apparent_directions(const std::vector<Star>& stars, const Instant& instant);

}  // namespace coppermoon::almanac
