// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

#include "algebra/random.h"
#include "photons/trace.h"

namespace coppermoon::photons {

/// The inner edge of the ring: the least radius of the Earth's limb [m].
double innermost_radius_m(const atmosphere::Atmosphere& atmosphere);

/// A photon packet on its way from the Sun: a straight line that will meet the ring of the air.
///
/// Given     random          uniform numbers; four are taken
///           sun_distance_m  from the Earth's centre to the Sun's
/// Returned  a ray in the shadow frame (Z away from the Sun, origin at the Earth's centre) from a
///           random place on the solar disc, whose impact parameter b is random on the ring from
///           the innermost radius to the top of the air: pdf 2 b / (b₁² − b₀²), all azimuths alike
Ray aimed_at_the_ring(algebra::Random& random, double sun_distance_m,
                      const atmosphere::Atmosphere& atmosphere);

/// Where a ray crosses the plane that stands `depth_m` behind the Earth's centre, across the shadow
/// axis.
glm::dvec3 at_depth(const Ray& ray, double depth_m);

}  // namespace coppermoon::photons
