// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Writes a film as a single USD stage (.usda) beside its textures. The stage contains the Moon, the observer's camera,
/// and moonlight as a distant light [lux]. Each has a time sample per frame, with the first frame's values as defaults.
/// The layer's customLayerData gives the contacts' time codes. If the film has an observer, the sky [cd/m²] is added as
/// a dome light 256 texels wide.
///
/// The Moon's light comes from MaterialX nodes, which multiply a sunlit Moon by the eclipse's shader (eclipse_shader);
/// their images are written beside the stage. The stage's UsdPreviewSurface shows the film's textures.
///
/// Given     film    with textures in linear Rec.709 or ACEScg, and with its light
///           frames  two or more, in increasing order
/// Accuracy  that of eclipse_shader for the Moon, whose sunlit illuminance is correct in each frame; 0.2 % for the
///           light on a white card
/// Omits     the flattening of a low Moon; the glow of the air in front of the Moon; stars
/// Throws    Error  as eclipse_shader; when a file cannot be written
void write_stage(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

/// Refuses a stage that cannot be made from a film.
///
/// Throws  Error  for a file name that USD cannot use, a folder other than the film's, a film without textures or with
///                fewer than two frames, or the colour space ciexyz_d65
void require_stage(const std::filesystem::path& path, const Film& film);

}  // namespace coppermoon::uses
