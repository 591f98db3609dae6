// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "algebra/quantity.h"
#include "surface/photometry.h"

namespace coppermoon::surface {

/// Colour and opposition surge of each place relative to the mean Moon's. Maps as
/// albedo_map.h says, smooth, of cells of one degree and two.
struct Ground {
  /// c: natural logarithm of its reflectance at 415 nm over that at 566 nm; above 0: bluer
  algebra::Grid<float> colour;
  algebra::Grid<float> surge;  ///< s: amplitude of the shadow-hiding opposition surge
};

/// The largest |c| that `colour` holds: what lies beyond counts as that.
inline constexpr double strongest_colour = 0.15;

/// Colour and surge measured by a camera in orbit (LROC).
///
/// Returned  c and s as they are, of no mean taken; smoothed by a binomial three cells wide, twice,
///           for single cells err by 0.012 in c. Beyond latitude 70 degrees, where nothing was
///           measured, the harmonic function that joins the last rows: smooth, without a seam, at the
///           pole their mean
/// Accuracy  places to a degree; c to 0.006, s to 0.03, as neighbouring cells tell
/// Omits     the surge's width, which the same table has: it follows the latitude, as the phases that
///           the camera saw do, and not the ground
/// Source    baker/surface/data/lunar_blue_ratio.csv, lunar_surge_amplitude.csv: Sato et al. (2014),
///           Resolved Hapke parameter maps of the Moon
Ground measured_ground();

/// Colour and surge relative to the mean of the disc that a map makes: with them the full Moon keeps the mean
/// spectrum and the mean phase curve:
///
///     sum of mu A f c = 0, and so with s        over the disc as seen from above latitude 0,
///                                               longitude 0, lit from there too
///
/// Given   normal_albedo  as albedo_map.h says
/// Throws  Error          as geometric_albedo
Ground ground_under(const algebra::Grid<float>& normal_albedo, Photometry photometry);

/// How a place's spectrum departs from the mean Moon's: its reflectance over the mean spectrum is
/// A (1 + c k), with
///
///     k = -5.4578e-3 x + 7.7136e-6 x^2        x = lambda - 566 nm
///
/// 1 at 415 nm, 0 at 566 nm and -0.3745 at 643 nm: the first principal component of the logarithms of
/// the reflectances at 415 and 643 nm over that at 566 nm over all cells of the disc, weighted by
/// projected area. It holds 94 % of their variance.
///
/// Given     wavelength  380 to 780 nm
/// Returned  1.282 at 380 nm, -0.815 at 780 nm
/// Accuracy  0.7 % of the ratio of 643 to 566 nm, RMS over the disc. Beyond these bands it is the
///           parabola's going on
/// Throws    Error  when the wavelength is outside its range
/// Source    Sato et al. (2014)
double colour_spectrum(algebra::Wavelength wavelength);

/// How a place's phase curve departs from the mean Moon's: it is P (1 + s q), with P the
/// phase_factor and q the derivative of the logarithm of Hapke's surge by its amplitude:
///
///     q(g) = B(g) / (1 + Bs0 B(g) + m) less the same at 1.5 degrees
///     B(g) = 1 / (1 + tan(g/2) / hs)
///
/// Bs0 = 1.87, hs = 0.073: means over the disc and within 20 degrees of the equator; m = 0.158:
/// light scattered more than once, over p. Ground that hides more shadows, the maria, is dimmer at
/// large phases and a little brighter at small ones than one phase curve for all makes it.
///
/// Returned  0 with yapo_cutler; 0.0074 at 0.95 degrees, as the Moon has within the umbra, -0.059
///           at 7 degrees, -0.227 at 60
/// Accuracy  in an eclipse it changes a place by 0.3 % at most. A local width would change it by 1 %
///           rms; those measured are not the ground's (see measured_ground)
/// Omits     change of the phase function by place
/// Source    Hapke (2012), Theory of Reflectance and Emittance Spectroscopy; Sato et al. (2014)
double surge_slope(Photometry photometry, algebra::Angle phase);

}  // namespace coppermoon::surface
