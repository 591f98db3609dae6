// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "uses/film/film.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {

/// Refuses a film whose user's scene is not an existing .pov file, or which has no observer, or which makes textures.
void require_scene(const Film& film);

/// The observer, air and stars for a frame of the user's scene, even if the Moon is below the horizon. The camera in
/// the view is not used, because the scene has its own.
View scene_view(const Film& film, const almanac::SkyState& sky);

/// Fingerprint of a scene and of the files beside it whose names it quotes, directly or through .inc and .pov files.
/// The fingerprint is appended to FilmRecord::map_contents. It is empty without a scene.
std::string scene_contents(const std::filesystem::path& scene);

/// Renders a frame of the user's scene as an image in linear Rec.709 [cd/m²]. POV-Ray works in a temporary folder that
/// holds moon.inc, eclipse_stars.inc, coppermoon.inc, and the frame's sky and texture.
///
/// Throws  Error  when POV-Ray is missing or fails; names the scene and the frame
texture::Image rendered_scene(const Film& film, std::size_t frame, const LitScene& scene,
                              int threads);

}  // namespace coppermoon::uses
