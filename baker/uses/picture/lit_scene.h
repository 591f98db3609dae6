// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "povray_scenes/scene.h"
#include "texture/usd_text.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/frame_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Scene that was made, and its view.
struct LitScene {
  LitMoon moon;
  View view;
  BakedMoon texture;
  FrameSky sky;
};

/// View for a frame: flattening of the disc by less than a quarter of a pixel is left out.
struct FrameView {
  View view;
  std::vector<std::string> left_out;
};

/// Throws  Error  as view_of
FrameView view_for_frame(const ViewRequest& request, const almanac::SkyState& sky);

/// Moon with its texture's width, where none is asked for: `texels_per_pixel` times π times the disc's diameter, which
/// matches the pixels in the middle of the disc.
MoonRequest fitted(MoonRequest moon, const povray_scenes::SceneCamera& camera);

/// Options of a scene's texture.
struct SceneBaking {
  Baking texture = {};
  algebra::Progress light = {};
};

/// View, and the Moon ready to be baked: a scene without its files.
LitScene lit_scene(const MoonRequest& moon, const ViewRequest& view, const almanac::SkyState& sky,
                   const SceneBaking& baking = {});

/// Renderer that a scene's folder is written for.
enum class Renderer { povray, mitsuba };

/// Refuses a folder in which a scene would overwrite a file of somebody's own, or one that was changed; or
/// a link. The folder need not be there.
///
/// Throws  Error
void require_scene_folder(const std::filesystem::path& folder, const ViewRequest& view,
                          Renderer renderer = Renderer::povray);

/// Writes moon.inc, eclipse_stars.inc and coppermoon.inc beside a scene that has an observer: the Moon and the
/// stars of it, ready for a scene written by hand (povray_scenes::moon_include, star_include). Nothing
/// without an observer. The sky that moon.inc shows is write_sky's.
///
/// Given     request   of the scene's view, for the air of its sky
/// Accuracy  illuminance 0.2 %, of a disc of 360 rows
void write_moon_include(const std::filesystem::path& folder, const LitScene& scene,
                        const ViewRequest& request);

/// Bakes the texture, and writes it, the air's light (eclipse_air.exr, for POV-Ray alone, where the sky is not black), scene
/// and settings into a folder, made when only its last part
/// is missing; a folder made so is gone again when they cannot be written.
///
/// Given  lights  stars and planets for the renderer (see scene_lights)
void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const std::vector<povray_scenes::SkyLight>& lights = {},
                     Renderer renderer = Renderer::povray);

/// Camera of a view and light of its Moon, for USD.
///
/// Given  space  of the light's colour
texture::UsdMoment usd_moment(const LitMoon& moon, const View& view, colour::WorkingSpace space);

/// Luminance of each channel of a space.
std::array<double, 3> luminance_of_channels(colour::WorkingSpace space);

}  // namespace coppermoon::uses
