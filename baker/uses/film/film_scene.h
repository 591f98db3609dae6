// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "uses/film/film.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {

/// Throws  Error  when the film's scene is no .pov file, has no observer, or stands beside textures
void require_scene(const Film& film);

/// View of a scene's observer, air and stars, also where the Moon is below the horizon; the scene has its own camera.
View scene_view(const Film& film, const almanac::SkyState& sky);

/// Fingerprint, behind those of a record's map, of a scene and the files beside it that it, or an .inc or .pov file among
/// them, names in quotes; empty without a scene.
std::string scene_contents(const std::filesystem::path& scene);

/// Frame of the film's scene, linear Rec.709 [cd/m²]: POV-Ray renders it in a folder that is gone afterwards, beside
/// moon.inc, eclipse_stars.inc, coppermoon.inc, sky and texture of that moment.
///
/// Throws  Error  when POV-Ray is not there, or fails: names scene and frame
texture::Image rendered_scene(const Film& film, std::size_t frame, const LitScene& scene,
                              int threads);

}  // namespace coppermoon::uses
