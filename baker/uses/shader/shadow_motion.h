// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Motion of the Moon through the shadow, as power series in a scaled time t between −1 and 1:
///
///     t = seconds from greatest eclipse / half_s
///
/// A point p on the unit sphere in Moon-fixed axes has these coordinates in the shadow, in lunar radii:
///
///     east = centre_east + axes[0] · p,    north = centre_north + axes[1] · p,    depth = centre_depth + axes[2] · p
///
/// East, north and depth are the axes of eclipse::ShadowAxis.
struct ShadowMotion {
  double half_s = 0;                              ///< half of the time that the series cover
  std::array<std::vector<double>, 3> centre{};    ///< [east, north, depth][power], lunar radii
  std::array<std::vector<glm::dvec3>, 3> axes{};  ///< [east, north, depth][power], unit vectors
  double nearest = 0, farthest = 0;  ///< depths of the Moon's centre in the shadow [lunar radii]
};

/// The Moon's motion from at least ten minutes before the first contact to at least ten minutes after the last.
///
/// Accuracy  0.1 km on the Moon
ShadowMotion shadow_motion(const eclipse::Eclipse& eclipse);

/// A constant "motion" that holds the Moon where it is at the given moment.
ShadowMotion held_at(const almanac::Instant& when);

}  // namespace coppermoon::uses
