// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>

namespace coppermoon::atmosphere {

/// Equatorial radius [m] and flattening of the Earth.
///
/// Source  Espenak & Meeus (2009), Five Millennium Canon of Lunar Eclipses, NASA/TP-2009-214172
inline constexpr double earth_equatorial_radius_m = 6378137.0, earth_flattening = 1 / 298.257;

/// The Earth's body: an ellipsoid of revolution, or a sphere where both radii are alike.
struct Figure {
  double equatorial_radius_m = 6.378e6, polar_radius_m = 6.378e6;
  double sun_declination_rad = 0;  ///< how far the north pole is tipped towards the Sun

  bool operator==(const Figure&) const = default;
  bool sphere() const { return equatorial_radius_m == polar_radius_m; }
};

/// The ellipsoid, its pole tipped by the Sun's declination.
Figure ellipsoid(double sun_declination_rad);

/// The Earth's edge as the Sun sees it.
struct Limb {
  double radius_m;            ///< from the shadow axis to the ground
  double curvature_radius_m;  ///< of the ground along the light's way, which sets how long it is
};

/// The edge at a position angle about the shadow axis, from celestial north through east.
///
/// For the ellipsoid xᵀ A x = 1 and light along z: the outline is where (A x)·z = 0, the curvature
/// along it (zᵀ A z) / |A x|.
Limb limb_at(const Figure& figure, double position_angle_rad);

/// Height over the ground of a place in the shadow frame (X celestial east, Y north, Z away from
/// the Sun).
///
/// Accuracy  0.5 m up to 86 km: measured along the radius, not the vertical
double altitude_m(const Figure& figure, const glm::dvec3& position_m);

}  // namespace coppermoon::atmosphere
