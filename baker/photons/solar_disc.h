// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "algebra/random.h"

namespace coppermoon::photons {

/// Radius of the Sun [m].
///
/// Source  Yapo & Cutler (2009) §2.2
inline constexpr double solar_radius_m = 6.955e8;

/// Mean spectral irradiance of the unobstructed Sun at 1 au, for each band.
///
/// Given     edges_nm  the bands' edges: n + 1 increasing wavelengths, 379 to 781 nm, at least 1e-6 nm apart
/// Returned  n irradiances [W m⁻² nm⁻¹] on a surface that faces the Sun
/// Throws    Error     if an edge is outside its range
/// Source    ASTM E490-00a (2000)
std::vector<double> solar_irradiance(std::span<const double> edges_nm);

/// Uniformly random point on the Sun's disc (pdf 1/π), in solar radii.
glm::dvec2 random_place_on_disc(algebra::Random& random);

}  // namespace coppermoon::photons
