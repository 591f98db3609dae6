// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "uses/film/film.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {

/// Throws  Error  when the film's scene is not a .pov file, has no observer, or is asked for together with textures
void require_scene(const Film& film);

/// View for a scene's observer, air and stars, even if the Moon is below the horizon; the scene has its own camera.
View scene_view(const Film& film, const almanac::SkyState& sky);

/// Fingerprint of a scene and of the files beside it that it, or an .inc or .pov file among them, names in quotes.
/// It follows the fingerprints of a record's map; empty without a scene.
std::string scene_contents(const std::filesystem::path& scene);

/// Renders a frame of the film's scene, linear Rec.709 [cd/m²]. POV-Ray works in a temporary folder that holds
/// moon.inc, eclipse_stars.inc, coppermoon.inc, and the sky and texture of that moment.
///
/// Throws  Error  when POV-Ray is missing or fails: names scene and frame
texture::Image rendered_scene(const Film& film, std::size_t frame, const LitScene& scene,
                              int threads);

}  // namespace coppermoon::uses
