// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "algebra/progress.h"
#include "shadow/irradiance.h"

namespace coppermoon::shadow {

/// Refracted light without noise.
///
///     E(γ, θ)/E₀ = (1 + z/D)² / (π a²) ∫ [C(r₊) − C(r₋)] dφ       C(r) = ∫ T(b) b db, r(b) < r
///     r± = γ cos ψ ± √(a² − γ² sin² ψ)                             ψ = φ − θ
///
/// with φ the position angle of the limb, b the impact parameter, T the transmittance, r(b) the
/// signed distance from the axis at which the ray from the Sun's centre lands, a the radius of the
/// projected solar disc: every limb point sends its light along a line through the axis, and the
/// disc about the place cuts a chord out of it. C is continuous, so that focus on the axis and
/// caustics integrate away. A limb-darkened disc is a sum of uniform ones. Rays come from one table
/// for each column of air (photons::LimbTable); on an ellipsoid from two, at the equator and at the
/// pole, and by the limb's radius between them. Integrals over φ stop at the borders of regions.
///
/// Given     wavelengths_nm  380 to 780; axis_distances_m: increasing, 0 or more; rays: from the
///           one that grazes the ground to the air's top
/// Returned  one sector for air that is alike all around, else sectors_around; standard_error is 0
/// Accuracy  see the test's table of rays
/// Omits     that rays bend along the ellipsoid's vertical, not towards the axis: 21 km sideways at
///           most, of the 3600 km that the Sun's disc blurs
/// Throws    Error           when an argument is outside its range
RefractedLight by_quadrature(const atmosphere::Atmosphere& atmosphere,
                             const Arrangement& arrangement, std::span<const double> wavelengths_nm,
                             std::span<const double> axis_distances_m, int rays = 600,
                             const algebra::Progress& progress = {});

}  // namespace coppermoon::shadow
