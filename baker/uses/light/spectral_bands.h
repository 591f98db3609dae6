// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algebra/grid.h"
#include "atmosphere/observer_air.h"
#include "colour/working_space.h"

namespace coppermoon::uses {

/// Colour space of rendered images. POV-Ray and shaders assume this space.
constexpr auto picture_space = colour::WorkingSpace::linear_rec709;

/// Edges of the bands for sunlight and responses: 400 bands of 1 nm, from 380 to 780 nm.
std::vector<double> band_edges_nm();
std::vector<double> band_centres_nm();

/// Bands of equal width, within each of which the air and the spectra of stars change little.
struct BroadBands {
  std::vector<double> edges_nm, centres_nm;  ///< from 380 to 780 nm
  std::vector<double> sunlight;              ///< mean irradiance at 1 au [W m⁻² nm⁻¹]
  algebra::Grid<double> channels;  ///< weights for picture_space (CIE observer): [channel][band]
};

/// Given  width_nm  a divisor of 400
BroadBands broad_bands(double width_nm);

/// Wavelengths at which light is computed: the centres of `count` equal bands from 380 to 780 nm, 1 to 400 of them.
///
/// Throws  Error  when the count is outside its range
/// Source  Yapo & Cutler (2009) §2.2, who use 200
std::vector<double> wavelengths_nm(int count);

/// Converts weights of bands into equivalent weights of wavelengths. Between wavelengths, light is interpolated with a
/// cubic through the four nearest, so Σ weight(band) light(band) becomes a sum over wavelengths.
///
/// Given     weights  (channel, band)
/// Returned  (channel, wavelength), with `count` wavelengths
algebra::Grid<double> at_wavelengths(const algebra::Grid<double>& weights, int count);

/// Brings channels into the gamut. Colours with negative luminance, which interpolated noise can cause, become black.
void into_gamut_or_black(colour::WorkingSpace space, std::span<double> channels);

/// Weights of bands that give the channels of a white diffuse ground facing the Sun at 1 au:
///
///     w = C E / π
///
/// Given     response   C, [channel][band]: response to radiance, in the channel's unit per W m⁻² sr⁻¹ nm⁻¹
///           sightline  through an observer's air (atmosphere::transmittance_above); if absent, the view is from space
/// Returned  w          [channel][band]
algebra::Grid<double> white_ground_weights(
    const algebra::Grid<double>& response,
    const std::optional<atmosphere::Sightline>& sightline = {});

/// Weights of bands for ground with the Moon's mean colour and normal albedo 1 in V:
///
///     w = C E k_r / (π k_V)        k_r: reflectance, k_V: its mean over sunlight as the eye sees it
algebra::Grid<double> moonlight_weights(const algebra::Grid<double>& response,
                                        const std::optional<atmosphere::Sightline>& sightline = {});

/// Value of surface::colour_spectrum minus its mean, weighted by moonlight and the eye's response. Ground of any colour
/// therefore keeps its normal albedo in V.
double colour_at(double wavelength_nm);

/// Weights of moonlight for the reddest ground, followed by those for the bluest ground (surface::strongest_colour),
/// as texture::bake expects if the colour of the ground varies.
///
/// Given     weights  (channel, wavelength), for ground of the mean colour
///           at_nm    the wavelengths
/// Returned  (channel, wavelength), with twice as many channels: all for the reddest ground, then all for the bluest
algebra::Grid<double> reddest_and_bluest(const algebra::Grid<double>& weights,
                                         std::span<const double> at_nm);

}  // namespace coppermoon::uses
