// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace coppermoon::atmosphere {

/// Equatorial radius [m] and flattening of the Earth.
///
/// Source  Espenak & Meeus (2009), Five Millennium Canon of Lunar Eclipses, NASA/TP-2009-214172
inline constexpr double earth_equatorial_radius_m = 6378137.0, earth_flattening = 1 / 298.257;

/// Figure of the Earth: an ellipsoid of revolution, or a sphere if both radii are equal.
struct Figure {
  double equatorial_radius_m = 6.378e6, polar_radius_m = 6.378e6;
  double sun_declination_rad = 0;  ///< angle by which the north pole is tipped towards the Sun

  bool operator==(const Figure&) const = default;
  bool sphere() const { return equatorial_radius_m == polar_radius_m; }
};

/// The Earth's ellipsoid, with its north pole tipped towards the Sun by the Sun's declination.
Figure ellipsoid(double sun_declination_rad);

/// Earth's limb as seen from the Sun, at one position angle. Light paths in air are longer if the curvature is smaller.
struct Limb {
  double radius_m;            ///< distance from the shadow axis to the ground
  double curvature_radius_m;  ///< radius of curvature of the ground along the light's path
};

/// Limb at a position angle about the shadow axis, from celestial north through east.
///
/// For the ellipsoid xᵀ A x = 1 and light along z, the limb is where (A x)·z = 0, and the ground's curvature along z is
/// (zᵀ A z) / |A x|.
Limb limb_at(const Figure& figure, double position_angle_rad);

/// Height above the ground of a point in the shadow frame (X to celestial east, Y to north, Z away from the Sun).
///
/// Accuracy  0.5 m up to 86 km, because the height is measured along the Earth's radius, not along the vertical
double altitude_m(const Figure& figure, const glm::dvec3& position_m);

}  // namespace coppermoon::atmosphere
