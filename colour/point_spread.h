// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"

namespace coppermoon::colour {

/// A round hole that light comes in by.
struct Aperture {
  double diameter_m = 0.127;  ///< 1e-5 to 100
  double obstruction = 0;     ///< diameter of what stands before its middle, over its own: 0 to 0.9
};

/// Light of a point, spread over angle by diffraction.
///
///     p = π D² (1 − ε²) / 4λ² · [ (2 J₁(x)/x − ε² 2 J₁(εx)/εx) / (1 − ε²) ]²      x = π D θ / λ
///
/// Returned  per steradian: over all angles it comes to 1
/// Source    Born & Wolf, Principles of Optics, 8.5 and 8.6.2
double diffraction_spread_per_sr(const Aperture& aperture, double wavelength_nm, double angle_rad);

/// The share of a pattern's contrast that long exposures through turbulent air leave.
///
///     exp(−3.44 (ν F / 0.976)^(5/3))      F: the full width at half maximum of a point
///
/// Given   cycles_per_rad  ν
/// Omits   that F falls with the fifth root of wavelength; the outer scale of turbulence
/// Source  Fried (1966), J. Opt. Soc. Am. 56, 1372, with r₀ = 0.976 λ/F
double seeing_transfer(double cycles_per_rad, double width_rad);

/// What blurs one channel of a picture.
struct Blur {
  Aperture aperture{};
  double wavelength_nm = 550;  ///< of diffraction; 0: none
  double seeing_rad = 0;       ///< full width at half maximum; 0: none
};

/// A picture whose every point is spread by aperture and air.
///
/// Given     picture    pixels square; beyond its edge it goes on as at the edge
///           pixel_rad  angle that a pixel takes in, above 0
/// Returned  nothing below 0 where the picture is not; all light kept, but for what crosses an edge
/// Accuracy  1e-9 of the brightest pixel: of the transforms. Diffraction is averaged over a pixel,
///           which widens it by 0.29 pixel (standard deviation)
/// Omits     diffraction where a pixel takes in 32 λ/D: some hundredth of a point's light; seeing
///           of less than 1/32 pixel: 1e-5 of it
/// Throws    Error  when the aperture, an angle or the wavelength is outside its range
algebra::Grid<double> blurred(const algebra::Grid<double>& picture, const Blur& blur,
                              double pixel_rad);

}  // namespace coppermoon::colour
