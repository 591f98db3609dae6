// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "algebra/progress.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Refracted light without noise, for air that is alike all around the Earth.
///
///     E(γ)/E₀ = (1 + z/D)² / (π a²) ∫ T(b) b Φ(r(b), γ) db
///
/// with b the impact parameter, T the transmittance, r(b) where the ray lands, a the radius of the
/// projected solar disc and Φ the angle of the arc of radius |r| inside the disc centred at γ:
/// focus on the axis and caustics integrate away. Between two rays T b is taken at its logarithmic
/// mean and Φ exactly, from the area that the disc shares with a circle: dA/dr = |r| Φ. Rays crowd
/// below the altitudes where the air's slope breaks, and cells are cut near the axis.
///
/// Given     wavelengths_nm  380 to 780; axis_distances_m: increasing, 0 or more; rays: from the
///           one that grazes the ground to the air's top
/// Returned  one sector; standard_error is 0
/// Accuracy  at 600 rays, against 16 000: 3e-4 at 550 nm, 1.5e-3 at 450 nm, both on the axis; 2e-5
///           outside 4500 km
/// Throws    Error           when the air differs by region, or an argument is outside its range
RefractedLight by_quadrature(const atmosphere::Atmosphere& atmosphere,
                             const Arrangement& arrangement, std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m, int rays = 600,
                             const algebra::Progress& progress = {});

}  // namespace coppermoon::shadow
