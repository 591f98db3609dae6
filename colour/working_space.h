// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// Colour space of a scene-linear image. In all of them white is D65; in the RGB spaces, it has R = G = B.
enum class WorkingSpace { linear_rec709, acescg, ciexyz_d65 };

/// Name of a space in file names and in config.ocio: lin_rec709, acescg, lin_ciexyzd65_scene.
std::string_view name(WorkingSpace space);

/// Identifier of a space in files (OpenEXR's `colorInteropID`): lin_rec709_scene, lin_ap1_scene, lin_ciexyzd65_scene.
///
/// Source  ASWF Color Interop Forum, Color Space Encodings for Texture Assets and CG Rendering 1.1.0 (July 2026)
std::string_view interop_id(WorkingSpace space);

/// All names of a space; the first is the one that `name` returns.
std::span<const std::string_view> aliases(WorkingSpace space);

/// The space with a given name or alias, matched without regard to case.
///
/// Throws  Error  for any other name, listing the three spaces
WorkingSpace working_space(std::string_view name_or_alias);

/// The space named in a file's name, such as ACEScg in "moon_acescg.0001.exr", in upper or lower case; nothing if none.
std::optional<WorkingSpace> space_in_name(std::string_view file_name);

/// Whether a file's name contains the name of a colour space that is not a WorkingSpace, as "moon_aces.exr" does.
bool names_another_space(std::string_view file_name);

/// Matrix from absolute XYZ (scene white D65) to the channels of a space; white of luminance Y has R = G = B = Y.
///
/// Rec.709 has the same white as the scene. ACEScg's white is close to D60, so colours are adapted with Bradford's cone
/// responses. The matrix is derived from the primaries in double precision.
///
/// Source  ITU-R BT.709; SMPTE ST 2065-1 and S-2014-004 (ACEScg); Lam (1985), as in ICC.1 annex E
glm::dmat3 channels_from_xyz(WorkingSpace space);

/// Weights that turn band means of spectral radiance into the channels of a space.
///
/// Given     edges_nm  as in xyz_weights
///           response  a camera, as in camera_spectra, whose sensitivities and colour matrix are used; one that is not
///                     spectral (see is_spectral) means the CIE 1931 observer
/// Returned  weights   [channel][band], cd/m² per W m⁻² sr⁻¹ nm⁻¹
/// Throws    Error     as for xyz_weights and camera_spectra
algebra::Grid<double> channel_weights(WorkingSpace space, std::span<const double> edges_nm,
                                      const std::string& response = {});

/// x and y of red, green, blue and white, as in an OpenEXR file's `chromaticities` attribute. For XYZ, these are
/// its axes and the equal-energy white (1, 1, 1).
std::array<float, 8> chromaticities(WorkingSpace space);

/// Luminance Y of a colour [cd/m²].
///
/// Given  channels  three values
double luminance(WorkingSpace space, std::span<const double> channels);

/// The largest of a colour's Rec.709 channels [cd/m²], whatever space the colour is given in. It is the first to clip.
///
/// Given  channels  three values
double brightest_channel(WorkingSpace space, std::span<const double> channels);

/// D65 white of luminance 1, in the channels of a space.
glm::dvec3 white(WorkingSpace space);

/// Desaturates a colour with a negative channel towards grey of the same luminance, until no channel is negative.
///
/// Deep reds and blue-greens outside Rec.709 become paler at the same luminance. Colours within it stay as they are.
///
/// Given   channels  three values, changed in place
/// Throws  Error     when a channel is not finite, or the luminance is negative
void into_gamut(WorkingSpace space, std::span<double> channels);

}  // namespace coppermoon::colour
