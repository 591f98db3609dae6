// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "algebra/quantity.h"

namespace coppermoon::photons {

/// Ratio of the radiance at a point of the Sun's disc to the mean radiance of the disc.
///
///     I(μ)/Ī = Σ A_k μ^k / (A_0 + 2 Σ A_k/(k + 2))        k = 0 … 5,   A_k linear in wavelength
///
/// Given     wavelength  380 to 780 nm
///           cos_angle   μ = √(1 − ρ²), with ρ the distance from the centre in solar radii; 0 at the limb, 1 at the
///                       centre
/// Returned  at 550 nm, 1.246 at the centre and 0.33 at the limb; the mean over the disc is 1
/// Accuracy  compared with Neckel (2005), whose fit is smooth in wavelength, for μ >= 0.1: 1 % (400 to 780 nm) or 1.3 %
///           (385 nm) of the radiance at the centre
/// Omits     spectral lines, because the table is for the continuum
/// Throws    Error       if an argument is outside its range
/// Source    Neckel & Labs (1994), Solar Phys. 153, 91
double limb_darkening(algebra::Wavelength wavelength, double cos_angle);

/// The Sun's disc as a stack of concentric uniform discs.
struct DiscLayers {
  std::vector<double> radius;        ///< [layer], in solar radii; the first is 1, the whole disc
  algebra::Grid<double> brightness;  ///< (layer, wavelength), relative to the disc's mean radiance
};

/// Divides the Sun's disc into layers. The share of the Sun's light that comes from an area of the disc is the sum,
/// over all layers, of a layer's brightness times its overlap with the area, divided by the area of the unit disc.
///
///     With limb darkening: one layer of radius 1 and brightness I(0)/Ī, and 32 layers of radius √(1 − μ²) and
///     brightness w I′(μ)/Ī, with Gauss nodes μ and weights w on (0, 1). Otherwise: one layer, radius and brightness 1
///
/// Given     wavelengths_nm  380 to 780 nm
/// Returned  layers for which Σ brightness radius² is 1 at every wavelength
/// Accuracy  light from within any radius ρ: 3e-4 of the Sun's light; the means of ρ² and ρ⁴ over the disc are exact
/// Throws    Error           if limb-darkened and a wavelength is outside its range
DiscLayers disc_layers(std::span<const double> wavelengths_nm, bool limb_darkened);

/// Polynomial Σ a_k μ^k, with μ the cosine of the angle between the light and the vertical on the Sun.
using DiscFunction = std::array<double, 6>;

/// The Sun's disc as a sum of a few functions of the cosine of the emission angle, the same at all wavelengths.
struct DiscTerms {
  std::vector<DiscFunction> functions;
  algebra::Grid<double>
      brightness;  ///< (term, wavelength): coefficient of the function; the mean radiance is 1
};

double value(const DiscFunction& function, double cos_angle);

/// Represents the Sun's disc by terms that are chosen greedily. The first term is the radiance at the middle
/// wavelength. Each further term is the largest residual (rms over the disc) that remains at any wavelength.
///
/// Given     wavelengths_nm  380 to 780 nm
///           count           largest number of terms, 1 to 6
/// Returned  for a uniform disc, a single term equal to 1. At every wavelength, the sum over all terms of brightness
///           times the function's mean over the disc is 1
/// Accuracy  error of radiance anywhere on the disc, relative to the mean radiance, 380 to 780 nm: two terms 0.07,
///           three 0.03, four 4e-3, six exact
/// Throws    Error           if limb-darkened and an argument is outside its range
DiscTerms disc_terms(std::span<const double> wavelengths_nm, bool limb_darkened, int count = 6);

}  // namespace coppermoon::photons
