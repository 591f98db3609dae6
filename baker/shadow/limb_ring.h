// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "eclipse/shadow_axis.h"
#include "photons/earth_limb.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Ring of sunsets: the Sun's image, refracted around the Earth's limb, as seen from one place in the shadow.
///
///     L = T(b) I(μ)        sin α = b/D
///
/// A ray that arrives with impact parameter b, at an angle α from the Earth's centre, has been bent by δ(b). D is the
/// distance of the place from the Earth's centre. Traced backwards, the ray either meets the Sun's disc at the cosine
/// μ, or misses the disc and carries no light. Along a ray, radiance changes only by the transmittance T.
///
/// Omits  light that the air scatters towards the place; bending along the ellipsoid's vertical instead of towards the
///        Earth's centre (the two directions differ by 0.2° at most)
class LimbRing {
 public:
  /// Interval of impact parameters [m].
  struct Extent {
    double lowest_m, highest_m;
  };

  /// Given   arrangement     distance and limb darkening of the Sun; the planes are not used
  ///         place           100 000 to 1 000 000 km behind the Earth
  ///         wavelengths_nm  380 to 780
  ///         rays            number of rays in the limb's table, 2 to 1e7
  /// Throws  Error           if an argument is outside its range, or there is no air
  LimbRing(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
           const eclipse::ShadowPlace& place, std::span<const double> wavelengths_nm,
           int rays = 1000);

  /// Writes the ring's radiance at one point, by wavelength, relative to the mean radiance of the Sun's disc.
  ///
  /// Given     position_angle_rad  about the Earth's centre, from the shadow frame's Y towards its X
  ///           impact_parameter_m  b, 0 to D
  /// Accuracy  the integral over the ring is within 0.3 % of the irradiance that by_quadrature finds
  void radiance(double position_angle_rad, double impact_parameter_m,
                std::span<double> values) const;

  /// Range of impact parameters at which the ring may have light. It begins at the lowest ground at the limb. It ends
  /// in the limb's table one ray above the highest ray from the Sun, or is empty if no ray comes from the Sun.
  Extent extent() const;

  /// Distance D of the place from the Earth's centre [m].
  double distance_m() const;

 private:
  /// Cosine μ at the point of the Sun's disc from which a ray comes; below 0 if the ray misses the disc.
  double cosine_on_sun(const glm::dvec3& outward, double impact_parameter_m,
                       double bending_rad) const;

  atmosphere::Figure earth_;
  Arrangement arrangement_;
  eclipse::ShadowPlace place_;
  std::vector<double> wavelengths_nm_;
  photons::WholeLimb limb_;
  glm::dvec3 position_m_;
};

}  // namespace coppermoon::shadow
