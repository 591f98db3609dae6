// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "algebra/progress.h"

namespace coppermoon::povray_scenes {

/// How POV-Ray is run.
struct RenderSettings {
  int threads = 0;                ///< 0: as many as there are processors; at most 512
  double timeout_s = 0;           ///< POV-Ray is stopped after that long; 0: never
  std::string povray = "povray";  ///< a program on the PATH, or an absolute path
};

/// Runs `povray eclipse.ini` in a scene's folder.
///
/// Given     folder    as write_scene left it, with its texture; may hold spaces and any letters
///           progress  told the fraction of the pixels rendered; 1 when the frame is there
/// Returned  the path of frame.exr, scene-linear half floats; it appears whole or not at all.
///           POV-Ray does not outlive the calling thread, not even one that is killed
/// Accuracy  the same bits on any number of threads
/// Throws    Error  when there is no scene, no POV-Ray, or it fails (with its own last words) or
///                  takes longer than allowed; an earlier frame.exr is then left as it was
std::filesystem::path render(const std::filesystem::path& folder,
                             const RenderSettings& settings = {},
                             const algebra::Progress& progress = {});

}  // namespace coppermoon::povray_scenes
