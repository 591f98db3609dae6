// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "povray_scenes/moon_scene.h"
#include "texture/usd_text.h"
#include "uses/picture/baked_moon.h"
#include "uses/picture/frame_sky.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// A Moon ready to be rendered, with its view, texture and sky.
struct LitScene {
  LitMoon moon;
  View view;
  BakedMoon texture;
  FrameSky sky;
};

/// View for a frame, in which a flattening of the disc by less than a quarter of a pixel is left out.
struct FrameView {
  View view;
  std::vector<std::string> left_out;
};

/// Throws  Error  as view_of
FrameView view_for_frame(const ViewRequest& request, const almanac::SkyState& sky);

/// Sets the width of the Moon's texture if none is asked for: `texels_per_pixel` times π times the disc's diameter,
/// which matches the pixels in the middle of the disc.
MoonRequest fitted(MoonRequest moon, const povray_scenes::SceneCamera& camera);

/// Options for baking a scene's texture.
struct SceneBaking {
  Baking texture = {};
  algebra::Progress light = {};
};

/// Makes a scene without writing its files: the view, and the Moon ready to be baked.
LitScene lit_scene(const MoonRequest& moon, const ViewRequest& view, const almanac::SkyState& sky,
                   const SceneBaking& baking = {});

/// The renderer that a scene's folder is written for.
enum class Renderer { povray, mitsuba };

/// Refuses a folder in which a scene would overwrite a link, a file from elsewhere, or one that was changed.
/// The folder need not exist.
///
/// Throws  Error
void require_scene_folder(const std::filesystem::path& folder, const ViewRequest& view,
                          Renderer renderer = Renderer::povray);

/// Writes moon.inc, eclipse_stars.inc and coppermoon.inc beside a scene that has an observer: its Moon and stars,
/// ready for a scene written by hand (povray_scenes::moon_include, star_include). Writes nothing
/// without an observer. The sky that moon.inc shows comes from write_sky.
///
/// Given     request   for the scene's view; sets the air of its sky
/// Accuracy  illuminance 0.2 %, for a disc of 360 rows
void write_moon_include(const std::filesystem::path& folder, const LitScene& scene,
                        const ViewRequest& request);

/// Bakes the texture, and writes it into a folder with the scene, its settings and, for POV-Ray, the light of a sky
/// that is not black (eclipse_air.exr). The folder is made when only its last part is missing, and removed again if
/// the files cannot be written.
///
/// Given  lights  stars and planets for the renderer (see scene_lights)
void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const std::vector<povray_scenes::SkyLight>& lights = {},
                     Renderer renderer = Renderer::povray);

/// A view's camera and the light of its Moon, for USD.
///
/// Given  space  for the light's colour
texture::UsdMoment usd_moment(const LitMoon& moon, const View& view, colour::WorkingSpace space);

/// Luminance of each channel of a colour space.
std::array<double, 3> luminance_of_channels(colour::WorkingSpace space);

}  // namespace coppermoon::uses
