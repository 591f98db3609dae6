// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "algebra/random.h"
#include "photons/trace.h"

namespace coppermoon::photons {

/// Inner radius of the ring of air at which photons are aimed. It is the least radius of the Earth's limb [m].
double innermost_radius_m(const atmosphere::Atmosphere& atmosphere);

/// Ray of a photon packet that leaves the Sun towards a random point of the ring of air around the Earth.
///
/// Given     random          generator from which four uniform numbers are drawn
///           sun_distance_m  distance from the Earth's centre to the Sun's centre
/// Returned  a ray in the shadow frame (Z away from the Sun, origin at the Earth's centre) that starts at a uniformly
///           random point of the solar disc. Its impact parameter b is uniform over the ring's area, from the innermost
///           radius b₀ to the top of the air b₁ (pdf 2 b / (b₁² − b₀²)), and its azimuth is uniform
Ray aimed_at_the_ring(algebra::Random& random, double sun_distance_m,
                      const atmosphere::Atmosphere& atmosphere);

/// Point where a ray crosses the plane `depth_m` behind the Earth's centre, perpendicular to the shadow axis.
glm::dvec3 at_depth(const Ray& ray, double depth_m);

}  // namespace coppermoon::photons
