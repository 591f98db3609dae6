// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <mutex>

#include "almanac/instant.h"

namespace coppermoon::almanac {

/// Where the Earth is and how it moves, GCRS axes.
struct EarthMotion {
  glm::dvec3 heliocentric_au, barycentric_au, velocity_au_per_day;
};

/// Source  ERFA eraEpv00
EarthMotion earth_at(const Instant& instant);

/// A direction as the moving Earth sees it.
///
/// Given  direction  unit, from where the Earth's centre is
/// Source ERFA eraAb
glm::dvec3 aberrated(const glm::dvec3& direction, const EarthMotion& earth);

/// GCRS axes from the mean ecliptic and equinox of 2000.
glm::dvec3 gcrs_from_ecliptic(const glm::dvec3& of_2000);

/// Held while libnova computes: it keeps statics.
std::mutex& libnova_is_single_threaded();

}  // namespace coppermoon::almanac
