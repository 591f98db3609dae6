// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "algebra/grid.h"
#include "almanac/sky.h"
#include "surface/photometry.h"

namespace coppermoon::surface {

/// Place of a texel's centre on an albedo map. The map is a Grid<float> in plate carrée: twice as many columns as rows,
/// row 0 in the north, longitude 0 in the middle, east to the right.
///
/// Given  row, column  indices of the texel
///        rows         number of rows in the map
almanac::SelenographicPoint texel_centre(std::size_t row, std::size_t column, std::size_t rows);

/// Value of a map at a place, interpolated bilinearly between texel centres and across the seam at longitude 180. From
/// the centre of the last row to the pole, the value is constant.
///
/// Given   at     place with any longitude; latitudes outside ±90° are clamped
/// Throws  Error  when the map is empty
double sampled(const algebra::Grid<float>& map, const almanac::SelenographicPoint& at);

/// Scales a map to a given geometric albedo of the full Moon:
///
///     mean over the disc of A f(mu) = p        f = radiance_factor_at_full_moon
///
/// with the disc seen and lit from latitude 0, longitude 0. "Full Moon" means a phase angle of 1.5 degrees. The
/// opposition surge at smaller phase angles comes on top of this.
///
/// Given     geometric_albedo  p, 0.01 to 1; the Moon's is 0.12 in V
/// Returned  normal albedo A at each texel
/// Accuracy  1e-3 of p for a map of any size, because the sum over the disc has at least 180 rows. At a phase angle of
///           exactly 1.5 degrees, the disc would be another 0.9e-3 darker, which is neglected
/// Throws    Error  when p is outside its range, the map is not 2:1, or its near side is black
/// Source    Allen's Astrophysical Quantities for 0.12. E. Schmidt's photometry of 11 January 2009 (4900 to 5400 cd/m2
///           at 1.64 degrees) implies 0.115 to 0.127; ROLO, with its own calibration, gives 0.135 at 1.5 degrees
algebra::Grid<float> normalised_to_geometric_albedo(algebra::Grid<float> map, Photometry photometry,
                                                    double geometric_albedo = 0.12);

/// Exponent that converts radiance factors at a phase angle of 60 degrees to those at full Moon, up to a constant
/// factor. At 60 degrees, the maria are darker compared with the highlands than they are at full Moon.
///
/// Source  a straight line fitted to the logarithms of all cells in Sato et al. (2014), weighted by area
inline constexpr double exponent_to_full_moon = 1 / 1.56;

/// Normal albedo, up to a constant factor, for a pixel value in NASA's CGI Moon Kit of 2019:
///
///     A = (0.16 + 0.24 v)^(2.8 exponent_to_full_moon)
///
/// Given   code  pixel value v, 0 to 1
/// Source  https://svs.gsfc.nasa.gov/4720: "a gamma of 2.8" and "the range (0.16, 0.4)", for I/F at 60 degrees
double kit_2019_albedo(double code);

/// Restores the contrast near the poles in the map from NASA's CGI Moon Kit of 2019. Beyond latitude 64 degrees, the
/// kit's map is blended into another map of lower contrast. If the logarithms of its albedos are plotted against those
/// of Sato et al. (2014), the slope falls from 0.9 to 0.35 at 69.5 degrees north and south. To make up for this,
/// deviations from a row's mean M are amplified:
///
///     A' = M (A / M)^(1/f)        f = 1 up to 64 degrees, 0.37 from 70 degrees on, linear in between
algebra::Grid<float> with_polar_contrast(algebra::Grid<float> map);

/// Geometric albedo of a map: the mean of A f(mu) over the disc, as in normalised_to_geometric_albedo.
double geometric_albedo(const algebra::Grid<float>& map, Photometry photometry);

}  // namespace coppermoon::surface
