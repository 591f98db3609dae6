// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>

#include "algebra/grid.h"

namespace coppermoon::colour {

/// What the three channels of a scene-linear image mean. All see D65 as white: R = G = B for the
/// RGB spaces.
enum class WorkingSpace { linear_rec709, acescg, ciexyz_d65 };

/// The space's name in file names and in config.ocio: lin_rec709, acescg, lin_ciexyzd65_scene.
std::string_view name(WorkingSpace space);

/// All its names, `name` first.
std::span<const std::string_view> aliases(WorkingSpace space);

/// The space that a name or alias stands for, in any case of letters.
///
/// Throws  Error  when none does; names the three
WorkingSpace working_space(std::string_view name_or_alias);

/// The space that a file's name says: as a part of it, in any case of letters, "moon_acescg.0001.exr".
std::optional<WorkingSpace> space_in_name(std::string_view file_name);

/// Whether a file's name has a word of colour spaces, as "moon_aces.exr", and yet says none of these.
bool names_another_space(std::string_view file_name);

/// Turns absolute XYZ (D65 scene) into the channels of the space, luminance kept: Y of white is R =
/// G = B.
///
/// Rec.709 shares the white of the scene; ACEScg's white is D60-like, so colours are adapted by
/// Bradford's cone responses. Derived in double from the primaries.
///
/// Source  ITU-R BT.709; SMPTE ST 2065-1 and S-2014-004 (ACEScg); Lam (1985), as in ICC.1 annex E
glm::dmat3 channels_from_xyz(WorkingSpace space);

/// Weights that turn band means of a spectral radiance into the channels of the space.
///
/// Given     edges_nm  as in xyz_weights
/// Returned  weights   [channel][band], cd/m² per W m⁻² sr⁻¹ nm⁻¹
/// Throws    Error     as xyz_weights
algebra::Grid<double> channel_weights(WorkingSpace space, std::span<const double> edges_nm);

/// x, y of red, green, blue, white: the `chromaticities` attribute of an OpenEXR file. XYZ has its
/// axes as primaries and the equal-energy white, as (1, 1, 1) is.
std::array<float, 8> chromaticities(WorkingSpace space);

/// Luminance [cd/m²] of a colour: Y of the XYZ it came from.
///
/// Given  channels  three
double luminance(WorkingSpace space, std::span<const double> channels);

/// The scene's white, D65, of luminance 1 in the channels of the space.
glm::dvec3 white(WorkingSpace space);

/// Moves a colour with a negative channel straight towards the grey of its luminance, until none
/// is.
///
/// Deep reds and blue-greens lie outside Rec.709: they become paler, not brighter or darker.
/// Colours inside stay as they are.
///
/// Given   channels  three, changed in place
/// Throws  Error     when a channel is not finite, or the luminance is negative
void into_gamut(WorkingSpace space, std::span<double> channels);

}  // namespace coppermoon::colour
