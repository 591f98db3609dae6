// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "algebra/grid.h"
#include "algebra/quantity.h"

namespace coppermoon::photons {

/// Radiance of a place on the Sun's disc over the mean radiance of the disc.
///
///     I(μ)/Ī = Σ A_k μ^k / (A_0 + 2 Σ A_k/(k + 2))        k = 0 … 5,   A_k linear in wavelength
///
/// Given     wavelength  380 to 780 nm
///           cos_angle   μ = √(1 − ρ²), ρ from the centre in solar radii: 0 at the edge, 1 in the
///                       middle
/// Returned  1.246 in the middle and 0.33 at the edge at 550 nm; its mean over the disc is 1
/// Accuracy  for μ >= 0.1 within 1 % (400 to 780 nm) or 1.3 % (385 nm) of the middle's radiance
///           of Neckel (2005), a fit smooth in wavelength
/// Omits     the spectral lines: the table is of the continuum
/// Throws    Error       when an argument is outside its range
/// Source    Neckel & Labs (1994), Solar Phys. 153, 91
double limb_darkening(algebra::Wavelength wavelength, double cos_angle);

/// The Sun's disc as a stack of uniform discs about one centre.
struct DiscLayers {
  std::vector<double> radius;        ///< [layer] in solar radii, the outermost, 1, first
  algebra::Grid<double> brightness;  ///< (layer, wavelength) over the mean radiance of the disc
};

/// The disc in layers: a lit area's share of the Sun's light is the sum over layers of brightness
/// times the share of the unit disc's area that it has in common with the layer.
///
///     limb-darkened: a layer of radius 1 with I(0), and six of radius √(1 − μ²) with w I′(μ), over
///     Ī, μ and w Gauss's on (0, 1);   else one layer of radius 1 and brightness 1
///
/// Given     wavelengths_nm  380 to 780 nm
/// Returned  Σ brightness radius² = 1 for every wavelength
/// Accuracy  the light inside any radius to 0.6 % (380 nm) to 0.3 % (780 nm) of the whole; the
///                           means of ρ² and ρ⁴ exactly
/// Throws    Error           when limb-darkened at a wavelength outside its range
DiscLayers disc_layers(std::span<const double> wavelengths_nm, bool limb_darkened);

}  // namespace coppermoon::photons
