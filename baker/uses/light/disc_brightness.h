// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "almanac/sky.h"
#include "texture/image.h"

namespace coppermoon::uses {

/// Irradiance from the whole Moon in each channel:
///
///     E = Σ L cos e ΔA / d²        e: emission angle, d: texel to the place
///
/// Given     texture  plate carrée, any channels of radiance or luminance
///           from_m   the place it is seen from, geocentric, GCRS axes; the Earth's centre
/// Returned  [channel]  irradiance or illuminance on a surface that faces the Moon
std::vector<double> irradiance_of_disc(const texture::Image& texture, const almanac::SkyState& sky,
                                       const glm::dvec3& from_m = {0, 0, 0});

/// Solid angle of the Moon from a place [sr], summed over the texels of irradiance_of_disc.
double solid_angle_of_disc(std::size_t rows, const almanac::SkyState& sky,
                           const glm::dvec3& from_m = {0, 0, 0});

/// Danjon's L of a totally eclipsed Moon, by its visual magnitude.
///
///     m = 4.2 − 3 L + (L/2)²
///
/// Returned  L, held to 0 to 4
/// Accuracy  0.4 between observers
/// Source    H. C. Vital's correlation of observers' estimates (REA Brazil, 2004 to 2015)
double danjon_estimate(double visual_magnitude);

}  // namespace coppermoon::uses
