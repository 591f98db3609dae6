// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "almanac/instant.h"

namespace coppermoon::almanac {

/// A fixed star.
struct Star {
  glm::dvec3 place;                     ///< at 2000.0, ICRS axes, unit
  double magnitude, b_minus_v;          ///< V; B − V
  glm::dvec3 motion_per_year{0, 0, 0};  ///< proper motion, across the place [radians]
};

/// Stars down to V = 9.0 within 10 degrees of the ecliptic, where the Moon may be, and down to V = 6.5 elsewhere.
///
/// Accuracy  against Hipparcos 0.02″ in place, 0.05 in magnitude, 0.03 in B − V. A few stars, such as Alcyone, have
///           their places at epoch 1991.25, as in Stellarium's catalogue: 0.4″ off
/// Omits     proper motion of stars that Hipparcos did not measure: one in four, mostly fainter than V = 8
/// Source    Hipparcos (ESA 1997), Tycho-2 (Høg et al. 2000) and NOMAD 1 (U.S. Naval Observatory), as
///           selected and rounded by baker/almanac/data/make_stars.py
const std::vector<Star>& stars();

/// Apparent directions of stars from the Earth's centre, with proper motion and aberration.
///
/// Returned  unit, GCRS axes, in the order of the stars
/// Accuracy  0.01″ against ERFA, within 1000 years of 2000
/// Omits     parallax; deflection by the Sun's gravity, which matters only near the Sun
std::vector<glm::dvec3> apparent_directions(const std::vector<Star>& stars, const Instant& instant);

}  // namespace coppermoon::almanac
