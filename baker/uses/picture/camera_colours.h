// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

namespace coppermoon::uses {

/// How a camera's own JPEG turns light into linear Rec.709: it multiplies the sensor's channels by gains, then mixes
/// them. In deep red light this differs much from gains on Rec.709 itself, where the sensor's green and blue
/// cancel.
struct CameraColours {
  glm::dmat3 channels_from_xyz{1};     ///< channels in which daylight (D65) is white
  glm::dmat3 rec709_from_channels{1};  ///< with daylight's white balance
  glm::dvec3 gains{1};                 ///< as shot, relative to daylight's
  /// Share of the brightest channel that is added to each, on average. Colours outside the gamut are cut off at 0, and
  /// noise and stray light are positive, so dark channels are brighter than the mixture.
  double lift = 0.01;
};

/// Colours of a camera with a response.
///
/// Given   response  as in MoonRequest; any but a spectral one has the channels of Rec.709
///         as_shot   gains of the channels as as_shot_balance gives them; if absent, daylight's
/// Throws  Error     as colour::camera_spectra
CameraColours camera_colours(const std::optional<std::string>& response,
                             const std::optional<std::array<double, 3>>& as_shot);

/// Converts moonlight to linear Rec.709 and brings it into the gamut as for renders. Channels are 1e-12 or more.
///
/// Given  xyz  of moonlight, in any unit
std::array<double, 3> rec709_of(std::span<const double> xyz);

/// X, Y, Z of light in linear Rec.709.
std::array<double, 3> xyz_of_rec709(std::span<const double> rgb);

/// Moonlight as a camera writes it: linear Rec.709, each channel at least `least` times the brightest, and 1e-12, before
/// the lift is added.
///
/// Given  colours  if absent, light is brought into the gamut as in renders
///        xyz      of moonlight, in any unit
std::array<double, 3> rec709_by(const std::optional<CameraColours>& colours,
                                std::span<const double> xyz, double least);

/// Parts of a Rec.709 channel's light, with its lift, that come from the camera's red, green and blue channels.
///
/// Given  xyz  of moonlight, in any unit
glm::dvec3 parts_of(std::size_t channel, const CameraColours& colours, std::span<const double> xyz);

}  // namespace coppermoon::uses
