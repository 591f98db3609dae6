// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

#include "povray_scenes/render.h"

namespace coppermoon::povray_scenes {

/// Frame of a film whose scene somebody wrote.
struct OwnScene {
  std::filesystem::path file;      ///< that POV-Ray reads; what it names may stand beside it
  std::size_t width, height;       ///< [pixels]
  std::size_t frame, first, last;  ///< its number, and those of the film's first and last frame
};

/// Renders one frame, anti-aliased as write_scene's, as a part of POV-Ray's animation: `frame_number` is its number, `clock`
/// goes from 0 in the film's first frame to 1 in its last.
///
/// Given     folder  new for this frame; POV-Ray looks there for what the scene names, then beside the scene, then where the
///                   user's povray.ini says
/// Returned  the path of an .exr in the folder, scene-linear
/// Accuracy  the same bits on any number of threads, those of radiosity nearly so (POV-Ray's High_Reproducibility)
/// Throws    Error   when there is no POV-Ray, or it fails, with its own last words: file, line and fault
std::filesystem::path render_own(const std::filesystem::path& folder, const OwnScene& scene,
                                 const RenderSettings& settings = {});

}  // namespace coppermoon::povray_scenes
