// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "algebra/quantity.h"
#include "almanac/instant.h"

namespace coppermoon::almanac {

/// Mean radius of the Moon.
///
/// Source  IAU WGCCRE 2009
inline constexpr algebra::Length lunar_radius = algebra::kilometres(1737.4);

/// A place on the Moon in the mean-Earth/polar-axis frame. Latitude is positive north, longitude is positive east.
struct SelenographicPoint {
  algebra::Angle latitude, longitude;
};

/// Orientation of the Moon: the rotation from GCRS axes to the Moon-fixed mean-Earth/polar-axis frame, with X towards
/// 0°, Y towards 90° E and Z towards the north.
///
///     R = Rz(W) Rx(90° − δ₀) Rz(90° + α₀)        pole (α₀, δ₀), prime meridian W, in the ICRF
///
/// Given     instant   the moment when the light left the Moon
/// Accuracy  150 m on the Moon's surface, or 0.005°, according to the source's authors
/// Source    Archinal et al. (2011), Celest. Mech. Dyn. Astron. 109, 101 (IAU WGCCRE 2009)
glm::dmat3 selenographic_from_gcrs(const Instant& instant);

/// The selenographic point that lies in a given direction from the Moon's centre.
///
/// Given   position   vector of any length from the Moon's centre, in the Moon-fixed frame
SelenographicPoint selenographic_point(const glm::dvec3& position);

/// The unit vector from the Moon's centre to a place on the Moon, in the Moon-fixed frame.
glm::dvec3 selenographic_direction(const SelenographicPoint& place);

}  // namespace coppermoon::almanac
