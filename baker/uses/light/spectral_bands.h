// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "atmosphere/observer_air.h"
#include "colour/working_space.h"

namespace coppermoon::uses {

/// Colour space of frames, strips and sheets. POV-Ray and shaders assume it.
constexpr auto picture_space = colour::WorkingSpace::linear_rec709;

/// Bands for sunlight and responses: 400 bands of 1 nm, from 380 to 780 nm.
std::vector<double> band_edges_nm();
std::vector<double> band_centres_nm();

/// Bands of equal width, within which air and the spectra of stars change little.
struct BroadBands {
  std::vector<double> edges_nm, centres_nm;  ///< from 380 to 780 nm
  std::vector<double> sunlight;              ///< in each band [W/m²]
  algebra::Grid<double> channels;  ///< of picture_space, for the CIE observer: [channel][band]
};

/// Given  width_nm  a divisor of 400
BroadBands broad_bands(double width_nm);

/// Wavelengths at which light is computed: the centres of `count` equal bands from 380 to 780 nm, 1 to 400 of them.
///
/// Throws  Error  when the count is outside its range
/// Source  Yapo & Cutler (2009) §2.2, for 200 of them
std::vector<double> wavelengths_nm(int count);

/// Weights for wavelengths that are equivalent to weights for bands. Between wavelengths, light is taken as a cubic
/// through the four nearest, so Σ weight(band) light(band) becomes a sum over wavelengths.
///
/// Given     weights  (channel, band)
/// Returned  (channel, wavelength), with `count` wavelengths
algebra::Grid<double> at_wavelengths(const algebra::Grid<double>& weights, int count);

/// Brings channels into the gamut. Colours with negative luminance, which cubics through noise can cause, become black.
void into_gamut_or_black(colour::WorkingSpace space, std::span<double> channels);

/// Weights of bands that give the channels of a white diffuse ground facing the Sun at 1 au:
///
///     w = C E / π
///
/// Given     response   C, [channel][band]: to radiance, in the channel's unit per W m⁻² sr⁻¹ nm⁻¹
///           sightline  through an observer's air, which reddens the light (see
///                      atmosphere::transmittance_above); if absent, the ground is seen from space
/// Returned  w          [channel][band]
algebra::Grid<double> white_ground_weights(
    const algebra::Grid<double>& response,
    const std::optional<atmosphere::Sightline>& sightline = {});

/// Weights of bands for ground with the Moon's mean colour and normal albedo 1 in V:
///
///     w = C E k_r / (π k_V)        k_V: k_r averaged over the Sun's light as the eye sees it
algebra::Grid<double> moonlight_weights(const algebra::Grid<double>& response,
                                        const std::optional<atmosphere::Sightline>& sightline = {});

/// Value of surface::colour_spectrum minus its mean, weighted by sunlit moonlight and V. Ground of any colour thus
/// keeps its normal albedo in V.
double colour_at(double wavelength_nm);

/// Weights of moonlight for the reddest ground, followed by those for the bluest ground (surface::strongest_colour),
/// as texture::bake expects if the colour of the ground varies.
///
/// Given     weights  (channel, wavelength) for mean ground
///           at_nm    the wavelengths
/// Returned  (channel or channels + channel, wavelength)
algebra::Grid<double> reddest_and_bluest(const algebra::Grid<double>& weights,
                                         std::span<const double> at_nm);

}  // namespace coppermoon::uses
