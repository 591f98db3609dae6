// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "eclipse/contacts.h"

namespace coppermoon::uses {

/// Motion of the Moon through the shadow, as power series in a time from −1 to 1:
///
///     t = seconds from greatest eclipse / half_s
///
/// A place p on the Moon (Moon-fixed axes, unit sphere) is then at this place in the shadow, in lunar radii:
///
///     east = centre_east + axes[0] · p,    north = centre_north + axes[1] · p,    depth = centre_depth + axes[2] · p
///
/// The frame is that of eclipse::ShadowAxis.
struct ShadowMotion {
  double half_s = 0;                              ///< from greatest eclipse to either end
  std::array<std::vector<double>, 3> centre{};    ///< [east, north, depth][power], lunar radii
  std::array<std::vector<glm::dvec3>, 3> axes{};  ///< [east, north, depth][power], unit vectors
  double nearest = 0, farthest = 0;               ///< depth of the Moon's centre, lunar radii
};

/// Motion from ten minutes before the first contact to ten minutes after the last, or longer on one side.
///
/// Accuracy  0.1 km on the Moon
ShadowMotion shadow_motion(const eclipse::Eclipse& eclipse);

/// The Moon at rest, at its place at one moment.
ShadowMotion held_at(const almanac::Instant& when);

}  // namespace coppermoon::uses
