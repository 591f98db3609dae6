// SPDX-License-Identifier: MIT
#pragma once

#include <array>
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
///     limb-darkened: a layer of radius 1 with I(0), and 32 of radius √(1 − μ²) with w I′(μ), over
///     Ī, μ and w Gauss's on (0, 1);   else one layer of radius 1 and brightness 1
///
/// Given     wavelengths_nm  380 to 780 nm
/// Returned  Σ brightness radius² = 1 for every wavelength
/// Accuracy  the light inside any radius to 3e-4 of the whole; the means of ρ² and ρ⁴ exactly
/// Throws    Error           when limb-darkened at a wavelength outside its range
DiscLayers disc_layers(std::span<const double> wavelengths_nm, bool limb_darkened);

/// A function of the cosine μ: Σ a_k μ^k.
using DiscFunction = std::array<double, 6>;

/// The Sun's disc as a sum of few functions of the cosine μ, the same for all wavelengths.
struct DiscTerms {
  std::vector<DiscFunction> functions;
  algebra::Grid<double>
      brightness;  ///< (term, wavelength): how much of each, over the mean radiance
};

double value(const DiscFunction& function, double cos_angle);

/// The disc in terms: the radiance in the middle of the wavelengths, and what others differ from it,
/// each time by that function which leaves least, as a mean over the disc.
///
/// Given     wavelengths_nm  380 to 780 nm
///           count           at most, 1 to 6
/// Returned  one term, 1, for a uniform disc;  Σ brightness times a function's mean over the disc is
///           1 for every wavelength
/// Accuracy  of the radiance anywhere, over the mean: 380 to 780 nm with two terms 0.07, with three
///           0.03, with four 4e-3, with six exact
/// Throws    Error           when limb-darkened and an argument is outside its range
DiscTerms disc_terms(std::span<const double> wavelengths_nm, bool limb_darkened, int count = 6);

}  // namespace coppermoon::photons
