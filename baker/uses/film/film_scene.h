// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "uses/film/film.h"
#include "uses/picture/lit_scene.h"

namespace coppermoon::uses {

/// Refuses a film whose scene cannot be rendered.
///
/// Given   film   with a scene
/// Throws  Error  for a scene that is no .pov file, without an observer, or beside textures and scenes of the Moon alone
void require_scene(const Film& film);

/// View for a frame of a film that has a scene, which has its own camera: observer, air and stars; also where the Moon is
/// below the horizon.
View scene_view(const Film& film, const almanac::SkyState& sky);

/// Fingerprint of a scene and of the files beside it that it names in quotes, as do the .inc and .pov files among these.
///
/// Omits   names that the scene puts together; what POV-Ray finds elsewhere
/// Throws  Error  when one cannot be read
std::string scene_contents(const std::filesystem::path& scene);

/// Frame of the film's scene, linear Rec.709 [cd/m²]: POV-Ray renders it in a folder that is gone afterwards, beside
/// moon.inc, eclipse_stars.inc, coppermoon.inc, sky and texture of that moment (write_moon_include). What the scene names
/// else is found beside it.
///
/// Throws  Error  when POV-Ray is not there, or fails: names scene and frame
texture::Image rendered_scene(const Film& film, std::size_t frame, const LitScene& scene,
                              int threads);

}  // namespace coppermoon::uses
