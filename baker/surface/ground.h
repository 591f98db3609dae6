// SPDX-License-Identifier: MIT
#pragma once

#include "algebra/grid.h"
#include "algebra/quantity.h"
#include "surface/photometry.h"

namespace coppermoon::surface {

/// Maps of the Moon's colour and opposition surge relative to their means, laid out as in albedo_map.h. They are
/// smooth, with cells of one degree for colour and two degrees for the surge.
struct Ground {
  /// c: natural logarithm of the reflectance at 415 nm divided by that at 566 nm; positive for ground that is bluer
  algebra::Grid<float> colour;
  algebra::Grid<float> surge;  ///< s: amplitude of the shadow-hiding opposition surge
};

/// Largest |c| in `colour`; larger values are clamped.
inline constexpr double strongest_colour = 0.15;

/// Colour and surge measured by a camera in orbit (LROC).
///
/// Returned  c and s as measured, means included. Both are smoothed twice by a binomial filter three cells wide,
///           because single cells are off by 0.012 in c. Beyond latitude 70 degrees, where there are no measurements, a
///           harmonic function continues the last rows and reaches their mean at the pole
/// Accuracy  1 degree in position; 0.006 in c and 0.03 in s, judging by the scatter between neighbouring cells
/// Omits     the surge's width, which the same source gives, because its values follow latitude, as the observed phase
///           angles do, and not the terrain
/// Source    baker/surface/data/lunar_blue_ratio.csv, lunar_surge_amplitude.csv: Sato et al. (2014),
///           Resolved Hapke parameter maps of the Moon
Ground measured_ground();

/// Colour and surge relative to their means over the full Moon's disc, so that the disc keeps the mean spectrum and
/// the mean phase curve:
///
///     sum of mu A f c = 0, sum of mu A f s = 0        over the disc seen and lit from latitude 0, longitude 0
///
/// Given   normal_albedo  A, laid out as in albedo_map.h
/// Throws  Error          if the map is empty, or its near side is black
Ground ground_under(const algebra::Grid<float>& normal_albedo, Photometry photometry);

/// Deviation k of a place's spectrum from the mean spectrum of the Moon, per unit of the colour c. The ratio of
/// reflectance to the mean spectrum is A (1 + c k), with
///
///     k = -5.4578e-3 x + 7.7136e-6 x^2        x = lambda - 566 nm
///
/// k is 1 at 415 nm, 0 at 566 nm and -0.3745 at 643 nm. It is the first principal component of the logarithms of the
/// reflectances at 415 and 643 nm, each divided by that at 566 nm, in all cells of the disc, weighted by projected
/// area. It explains 94 % of their variance.
///
/// Given     wavelength  380 to 780 nm
/// Returned  1.282 at 380 nm, -0.815 at 780 nm
/// Accuracy  0.7 % rms over the disc in the ratio of reflectances at 643 and 566 nm. Below 415 nm and above 643 nm, the
///           parabola is an extrapolation
/// Throws    Error  when the wavelength is outside its range
/// Source    Sato et al. (2014)
double colour_spectrum(algebra::Wavelength wavelength);

/// Deviation q of a place's phase curve from the mean curve, per unit of the surge's amplitude s. The curve is P (1 + s
/// q); P is the phase_factor, q the derivative of the logarithm of Hapke's surge with respect to its amplitude:
///
///     q(g) = B(g) / (1 + Bs0 B(g) + m) minus its value at 1.5 degrees
///     B(g) = 1 / (1 + tan(g/2) / hs)
///
/// Bs0 = 1.87 is the mean amplitude over the disc, hs = 0.073 the mean width within 20 degrees of the equator, and m =
/// 0.158 the ratio of multiply scattered light to Hapke's phase function p. Ground with stronger shadow hiding (the
/// maria) is dimmer at large phase angles, and a little brighter at small ones, than the mean phase curve predicts.
///
/// Returned  0 for yapo_cutler; otherwise 0.0074 at 0.95 degrees, the phase angle of a Moon within the umbra, -0.059 at
///           7 degrees and -0.227 at 60 degrees
/// Accuracy  during an eclipse, q changes the light of a place by 0.3 % at most. Local widths of the surge would change
///           the light by 1 % rms, but the measured widths do not reflect the terrain (see measured_ground)
/// Omits     variation of the phase function between places
/// Source    Hapke (2012), Theory of Reflectance and Emittance Spectroscopy; Sato et al. (2014)
double surge_slope(Photometry photometry, algebra::Angle phase);

}  // namespace coppermoon::surface
