// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>

namespace coppermoon::uses {

/// Weights with which linear Rec.709 red, green and blue add up to luminance.
inline constexpr std::array luminance_of_rec709{0.2126, 0.7152, 0.0722};

/// How a camera converts light to linear Rec.709 for its own JPEG: it multiplies the sensor's channels by gains, then
/// mixes them. In deep red light, gains applied to the Rec.709 channels would give a very different result, because the
/// sensor's green and blue cancel out in those channels.
struct CameraColours {
  glm::dmat3 channels_from_xyz{1};     ///< from XYZ to channels in which daylight (D65) is white
  glm::dmat3 rec709_from_channels{1};  ///< from channels balanced for daylight to Rec.709
  glm::dvec3 gains{1};                 ///< as-shot gains divided by the gains for daylight
  /// Light that is added to every channel of Rec.709, as a fraction of the brightest. Photographs show dark channels
  /// too bright by about this, as colours outside the gamut are clipped at 0, and noise and stray light are positive.
  double lift = 0.01;
};

/// The colour conversion of a camera with the given response.
///
/// Given   response  as in MoonRequest; if it is not spectral, the camera's channels are those of Rec.709
///         as_shot   the gains from as_shot_balance; if absent, those for daylight
/// Throws  Error     when colour::camera_spectra does
CameraColours camera_colours(const std::optional<std::string>& response,
                             const std::optional<std::array<double, 3>>& as_shot);

/// Converts moonlight to linear Rec.709, moved into the gamut. Channels are at least 1e-12, in the unit of `xyz`.
///
/// Given  xyz  CIE XYZ of the moonlight, in any unit
std::array<double, 3> rec709_of(std::span<const double> xyz);

/// Converts light from linear Rec.709 to CIE XYZ.
std::array<double, 3> xyz_of_rec709(std::span<const double> rgb);

/// Moonlight as a camera records it, in linear Rec.709. Each channel is raised to at least 1e-12, in the unit of `xyz`,
/// and to at least `least` times the brightest channel. Then CameraColours::lift times the brightest channel is added.
///
/// Given  colours  the camera's conversion; if absent, rec709_of is used
///        xyz      CIE XYZ of the moonlight, in any unit
std::array<double, 3> rec709_by(const std::optional<CameraColours>& colours,
                                std::span<const double> xyz, double least);

/// Contributions of the camera's red, green and blue channels to one channel of Rec.709, with CameraColours::lift.
///
/// Given  xyz  CIE XYZ of the moonlight, in any unit
glm::dvec3 parts_of(std::size_t channel, const CameraColours& colours, std::span<const double> xyz);

}  // namespace coppermoon::uses
