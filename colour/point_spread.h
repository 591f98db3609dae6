// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"

namespace coppermoon::colour {

/// Round aperture of a telescope or lens.
struct Aperture {
  double diameter_m = 0.127;  ///< allowed: 1e-5 to 100
  double obstruction = 0;     ///< diameter of the central obstruction / aperture, 0 to 0.9
};

/// Point-spread function due to diffraction, for a round aperture of diameter D and obstruction ε, at the angle θ.
///
///     p = π D² (1 − ε²) / 4λ² · [ (2 J₁(x)/x − ε² 2 J₁(εx)/εx) / (1 − ε²) ]²      x = π D θ / λ
///
/// Returned  p per steradian; its integral over all directions is 1
/// Source    Born & Wolf, Principles of Optics, 8.5 and 8.6.2
double diffraction_spread_per_sr(const Aperture& aperture, double wavelength_nm, double angle_rad);

/// Long-exposure transfer function of turbulent air (seeing).
///
///     exp(−3.44 (ν F / 0.976)^(5/3))      F: full width at half maximum of a star's image
///
/// Given   cycles_per_rad  the frequency ν
/// Omits   the decrease of F with the fifth root of the wavelength; the outer scale of turbulence
/// Source  Fried (1966), J. Opt. Soc. Am. 56, 1372, with r₀ = 0.976 λ/F
double seeing_transfer(double cycles_per_rad, double width_rad);

/// Blur of one colour channel by diffraction and seeing.
struct Blur {
  Aperture aperture{};
  double wavelength_nm = 550;  ///< for diffraction; 0 means no diffraction
  double seeing_rad = 0;       ///< full width at half maximum of a star's image; 0 means no seeing
};

/// Convolves a picture with diffraction and seeing.
///
/// Given     picture    has square pixels; beyond its edges, the edge pixels are repeated
///           pixel_rad  angle across a pixel, above 0
/// Returned  the blurred picture, not negative if `picture` is not; light is conserved, except for what crosses an edge
/// Accuracy  1e-9 of the brightest pixel in the transforms. Diffraction is averaged over a pixel, which widens it by
///           0.29 pixel (standard deviation)
/// Omits     diffraction if a pixel is 32 λ/D or more across (it spreads about a hundredth of a star's light); seeing
///           of less than 1/32 pixel (it spreads 1e-5)
/// Throws    Error  when the aperture, an angle or the wavelength is outside its range
algebra::Grid<double> blurred(const algebra::Grid<double>& picture, const Blur& blur,
                              double pixel_rad);

}  // namespace coppermoon::colour
