// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "atmosphere/atmosphere.h"

namespace coppermoon::photons {

/// What the air does to a ray that passes the limb.
struct LimbRay {
  double tangent_height_m;  ///< lowest altitude of the bent ray
  double bending_rad;       ///< total refraction, towards the Earth
  double transmittance;     ///< of dust and Rayleigh scattering along the path, and of ozone
  double optical_depth;     ///< of dust and Rayleigh scattering
};

/// The exact path of a ray through a column of air that is alike all around the Earth.
///
///     δ = −2 b ∫ (dn/dr) / (n √(n²r² − b²)) dr          τ = 2 ∫ (α + β) n r / √(n²r² − b²) dr
///
/// from the tangent radius r_t, where n r = b, to the top; in the variable √(r − r_t), which has no
/// singularity, by Gauss–Legendre between the altitudes where the air's slope breaks. Refractivity
/// and altitude are carried, not n and r: n r − b = h − h_t + (n − 1) r − (n_t − 1) r_t loses no
/// digits.
///
/// Given     impact_height_m  b − R, the impact parameter above the Earth's radius
/// Returned  nothing when the ray meets the ground
/// Accuracy  1e-8 relative; in the last millimetre under the top of the air, what the rounding of
///           altitudes leaves
/// Throws    Error  when the impact height is above the air's top or over 10 km below the ground
/// Source    Auer & Standish (2000), AJ 119, 2472, for the integrals
std::optional<LimbRay> limb_ray(double impact_height_m, const atmosphere::Atmosphere& atmosphere,
                                const atmosphere::Column& column, const atmosphere::Optics& optics);

}  // namespace coppermoon::photons
