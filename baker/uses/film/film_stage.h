// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Writes a film as one stage of USD, .usda, among its textures: the Moon, its observer's camera, and moonlight as a
/// distant light [lux], with samples at each frame, and those of the first as values without a time; contacts by time
/// code in the layer's customLayerData. Over a place also the night sky, a dome light [cd/m²], 256 texels wide.
///
/// The Moon shines by MaterialX's nodes: a sunlit Moon times the eclipse's shader (eclipse_shader), whose images stand
/// beside the stage. UsdPreviewSurface shows the film's textures.
///
/// Given     film    of textures in linear Rec.709 or ACEScg, with its light
///           frames  increasing, two or more
/// Accuracy  the shader's light as eclipse_shader, scaled in each frame to the illuminance of its texture; light on a
///           white card 0.2 %
/// Omits     flattening of a low Moon; air that shines before the Moon; stars
/// Throws    Error  as eclipse_shader; when a file cannot be written
void write_stage(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

/// Refuses a stage that cannot be made of a film.
///
/// Throws  Error  for another folder than the film's, without textures, for a single frame, for other
///                colour spaces, an unshadowed film
void require_stage(const std::filesystem::path& path, const Film& film);

}  // namespace coppermoon::uses
