// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <mutex>

#include "almanac/instant.h"

namespace coppermoon::almanac {

/// Position and velocity of the Earth, in GCRS axes.
struct EarthMotion {
  glm::dvec3 heliocentric_au, barycentric_au, velocity_au_per_day;
};

/// The Earth's motion at a given moment, from ERFA (eraEpv00).
EarthMotion earth_at(const Instant& instant);

/// Corrects a direction for the aberration that the Earth's motion causes.
///
/// Given   direction  unit vector from the Earth's centre
/// Source  ERFA eraAb
glm::dvec3 aberrated(const glm::dvec3& direction, const EarthMotion& earth);

/// Rotates a vector from the axes of the mean ecliptic and equinox of J2000 to GCRS axes.
glm::dvec3 gcrs_from_ecliptic(const glm::dvec3& of_2000);

/// Mutex to hold during every call to libnova, which keeps its state in static variables.
std::mutex& libnova_is_single_threaded();

}  // namespace coppermoon::almanac
