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

/// A view for a frame, and the effects that it leaves out, such as flattening of the disc by less than a quarter pixel.
struct FrameView {
  View view;
  std::vector<std::string> left_out;
};

/// Throws  Error  when view_of does
FrameView view_for_frame(const ViewRequest& request, const almanac::SkyState& sky);

/// Sets the width of the Moon's texture if the request leaves it open: `texels_per_pixel` times π times the disc's
/// diameter. With one texel per pixel, texels and pixels are equally large in the middle of the disc.
MoonRequest fitted(MoonRequest moon, const povray_scenes::SceneCamera& camera);

struct SceneBaking {
  Baking texture = {};
  algebra::Progress light = {};
};

/// Prepares a scene without writing its files: the view, and a Moon that is ready to be baked.
LitScene lit_scene(const MoonRequest& moon, const ViewRequest& view, const almanac::SkyState& sky,
                   const SceneBaking& baking = {});

/// The renderer for which a scene's folder is written.
enum class Renderer { povray, mitsuba };

/// Refuses a folder in which a scene would overwrite a link, a file that coppermoon did not write, or a file that was
/// changed after coppermoon wrote it. The folder need not exist.
///
/// Throws  Error
void require_scene_folder(const std::filesystem::path& folder, const ViewRequest& view,
                          Renderer renderer = Renderer::povray);

/// Writes moon.inc, eclipse_stars.inc and coppermoon.inc into a scene's folder. With these files, users can show the
/// scene's Moon and stars in their own POV-Ray scenes (povray_scenes::moon_include, star_include). Without an observer,
/// nothing is written. The image of the sky that moon.inc shows is written by write_sky.
///
/// Given     request   the request for the scene's view; it states the ozone and aerosol above the observer
/// Accuracy  illuminance 0.2 %, with a texture of 360 rows
void write_moon_include(const std::filesystem::path& folder, const LitScene& scene,
                        const ViewRequest& request);

/// Bakes the texture and writes it into a folder, together with the scene, its settings and, for POV-Ray, the light of
/// a sky that is not black (eclipse_air.exr). The folder is created if its parent exists, and removed again if the
/// files cannot be written.
///
/// Given  lights  stars and planets for the renderer (see scene_lights)
void write_lit_scene(const std::filesystem::path& folder, const LitScene& scene,
                     const std::vector<povray_scenes::SkyLight>& lights = {},
                     Renderer renderer = Renderer::povray);

/// The camera and the moonlight of a view, as one moment of a USD scene.
///
/// Given  space  colour space of the light
texture::UsdMoment usd_moment(const LitMoon& moon, const View& view, colour::WorkingSpace space);

/// Luminance of one unit of each channel of a colour space.
std::array<double, 3> luminance_of_channels(colour::WorkingSpace space);

}  // namespace coppermoon::uses
