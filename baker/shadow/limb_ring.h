// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "eclipse/shadow_axis.h"
#include "photons/limb.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// The ring of sunsets: what one place in the shadow sees around the black Earth, the image of the
/// Sun that the air bends around the limb.
///
///     L = T(b) I(μ)        sin α = b/D
///
/// A ray that comes to the place with impact parameter b, at the angle α from the Earth's centre, is
/// bent by δ(b); followed backwards it ends on the Sun's disc at the cosine μ, or beside it, and
/// there is no light. Radiance is what stays the same along a ray but for the transmittance T.
///
/// Omits  light that the air scatters towards the place; that rays bend along the ellipsoid's
///        vertical, not towards the Earth's centre: 0.2° of bending's direction at most
class LimbRing {
 public:
  /// Impact parameters [m].
  struct Extent {
    double lowest_m, highest_m;
  };

  /// Given   arrangement     its planes do not matter
  ///         place           100 000 to 1 000 000 km behind the Earth
  ///         wavelengths_nm  380 to 780
  ///         rays            of the limb's table, 2 to 1e7
  /// Throws  Error           when an argument is outside its range, or there is no air
  LimbRing(const atmosphere::Atmosphere& atmosphere, const Arrangement& arrangement,
           const eclipse::ShadowPlace& place, std::span<const double> wavelengths_nm,
           int rays = 1000);

  /// Writes radiance over the mean radiance of the Sun's disc, by wavelength.
  ///
  /// Given     position_angle_rad  about the Earth's centre, from the shadow frame's Y towards its X
  ///           impact_parameter_m  b, 0 to D
  /// Accuracy  integrated over the ring, 0.3 % of the irradiance that by_quadrature has
  void radiance(double position_angle_rad, double impact_parameter_m,
                std::span<double> values) const;

  /// Impact parameters of the ring: from the lowest ground of the limb up to the highest ray that
  /// comes from the Sun, one ray of the table to spare; both alike where none does.
  Extent extent() const;

  /// Distance D of the place from the Earth's centre [m].
  double distance_m() const;

 private:
  /// Where a ray bent so much comes from: cosine on the Sun's disc, below 0 beside it.
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
