// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/quantity.h"

namespace coppermoon::surface {

/// Spectrum of the Moon: the ratio of its reflectance at a wavelength to its reflectance at 780 nm.
///
///     k_r = -0.27063 + 2.6175e-3 lambda - 1.2673e-6 lambda^2        lambda [nm]
///
/// Given     wavelength  380 to 780 nm
/// Returned  k_r         dimensionless; 0.541 at 380 nm, 0.786 at 550 nm, 1 at 780 nm
/// Accuracy  0.42 % at worst, 0.21 % RMS, compared with the spectrum of Apollo 16 soil 62231 every 5 nm. The paper
///           states 0.3 %, which can be reached by a fit that is not forced to be 1 at 780 nm
/// Omits     differences between places (see surface::Ground)
/// Throws    Error  when the wavelength is outside its range
/// Source    Yapo & Cutler (2009), Rendering Lunar Eclipses; Pieters (1999), RELAB, for the soil
double lunar_reflectance_yapo_cutler(algebra::Wavelength wavelength);

}  // namespace coppermoon::surface
