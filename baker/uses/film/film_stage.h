// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Writes a film as a single USD stage, .usda, among its textures: the Moon, its observer's camera, and moonlight as a
/// distant light [lux]. Each has a sample per frame, with the first frame's values as defaults. The layer's
/// customLayerData lists the contacts by time code. Over a place, a dome light 256 texels wide adds the sky [cd/m²].
///
/// The Moon's light comes from MaterialX nodes: a sunlit Moon times the eclipse's shader (eclipse_shader), whose images
/// lie beside the stage. UsdPreviewSurface shows the film's textures.
///
/// Given     film    with textures in linear Rec.709 or ACEScg, and with its light
///           frames  in increasing order, two or more
/// Accuracy  the shader's light as eclipse_shader, scaled in each frame to the illuminance of its texture; light on a
///           white card 0.2 %
/// Omits     the flattening of a low Moon; the glow of the air in front of the Moon; stars
/// Throws    Error  as eclipse_shader; when a file cannot be written
void write_stage(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

/// Refuses a stage that cannot be made from a film.
///
/// Throws  Error  for a folder other than the film's, a film without textures, a single frame, other colour spaces,
///                or an unshadowed film
void require_stage(const std::filesystem::path& path, const Film& film);

}  // namespace coppermoon::uses
