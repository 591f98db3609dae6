// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "algebra/quantity.h"
#include "atmosphere/observer_air.h"

namespace coppermoon::uses {

using Rgb = std::array<double, 3>;  ///< linear Rec.709

/// Colour by two indices of astronomical photometry.
struct ColourIndices {
  double b_minus_v, v_minus_r;
};

/// Indices of sunlight.
ColourIndices sunlight_colour();

/// Light in bands of 10 nm from 380 to 780 nm: sunlight, times what makes up the difference of the indices.
///
///     E(λ) = E_sun(λ) 10^(−0.4 Δm(λ))
///
/// Δm runs straight through the differences in B (440 nm), V (550 nm) and R (641 nm), and on beyond them.
std::vector<double> spectrum_of(const ColourIndices& colour);

/// Colour of a spectrum in those bands, of luminance 1; black stays black.
Rgb colour_of(const std::vector<double>& spectrum);

/// A colour with luminance 1; black stays black.
Rgb normalised(Rgb light);

/// Vertical optical depths in those bands.
std::vector<atmosphere::VerticalDepths> band_depths(const atmosphere::ObserverAir& air);

/// Colour of a body's light that air scatters into a line of sight.
///
///     S(λ) = E(λ) g(λ) k_V/k(λ) 10^(−0.4 k(λ) X_m) (1 − 10^(−0.4 k(λ) X))
///
/// with g = τ(λ)/τ(550 nm) of molecules, or of aerosol: the law of atmosphere::moonlit_sky_cd_m2 at each wavelength. X_m
/// is the air mass of the body, X that of the line of sight.
///
/// Omits  light that is scattered twice
class ScatteredColour {
 public:
  /// Given  altitude  of the body
  ScatteredColour(const atmosphere::ObserverAir& air, const ColourIndices& body,
                  algebra::Angle altitude);

  /// Light scattered by molecules and by aerosol, of scattering terms (atmosphere::scattering_terms) 1.
  struct Pair {
    Rgb molecules, aerosol;
  };
  Pair along(algebra::Angle altitude) const;

 private:
  std::vector<double> extinction_mag_, of_molecules_, of_aerosol_;  ///< [band]
};

}  // namespace coppermoon::uses
