// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "algebra/progress.h"

namespace coppermoon::povray_scenes {

/// Pixels of a picture: columns left to right - 1, rows top to bottom - 1.
struct RenderWindow {
  std::size_t left, top, right, bottom;
};

/// Settings of a run of POV-Ray.
struct RenderSettings {
  int threads = 0;                ///< 0: as many as there are processors; at most 512
  double timeout_s = 0;           ///< POV-Ray is stopped after that long; 0: never
  std::string povray = "povray";  ///< a program on the PATH, or an absolute path
  /// Part of the picture that is rendered, at least two pixels wide and high; all else is black.
  std::optional<RenderWindow> window = {};
};

/// Runs `povray eclipse.ini` in a scene's folder.
///
/// Given     folder    as write_scene left it, with its texture; may hold spaces and any letters
///           progress  called with the fraction of the pixels rendered; 1 when the frame is there
/// Returned  the path of frame.exr, scene-linear half floats; it appears whole or not at all.
///           POV-Ray does not outlive the calling thread, not even one that is killed
/// Accuracy  the same bits on any number of threads, and in any window
/// Throws    Error  when there is no scene, no POV-Ray, or it fails (with its own last words) or
///                  takes longer than allowed; an earlier frame.exr is then left as it was
std::filesystem::path render(const std::filesystem::path& folder,
                             const RenderSettings& settings = {},
                             const algebra::Progress& progress = {});

/// Renders a frame that is read at once, and only once. POV-Ray is ended when it has closed the file, which saves the
/// third of a second that it sleeps before its own end.
///
/// Given   read  reads the whole file, and throws where it is not whole, as on a full disk; the file is then gone
/// Throws  Error  as render; also what `read` throws
void render_for(const std::function<void(const std::filesystem::path& exr)>& read,
                const std::filesystem::path& folder, const RenderSettings& settings = {},
                const algebra::Progress& progress = {});

/// Frame of a film whose scene somebody wrote.
struct OwnScene {
  std::filesystem::path file;      ///< that POV-Ray reads; what it names may stand beside it
  std::size_t width, height;       ///< [pixels]
  std::size_t frame, first, last;  ///< its number, and those of the film's first and last frame
};

/// Renders one frame, anti-aliased as write_scene's, as a part of POV-Ray's animation: `frame_number` is its number, `clock`
/// goes from 0 in the film's first frame to 1 in its last.
///
/// Given     folder  new for this frame; POV-Ray looks there for what the scene names, then beside the scene, then where
///                   the user's povray.ini says
/// Returned  the path of frame.exr, scene-linear
/// Throws    Error   as render; POV-Ray's words call the file scene.pov, its folder scene_folder
std::filesystem::path render_own(const std::filesystem::path& folder, const OwnScene& scene,
                                 const RenderSettings& settings = {});

}  // namespace coppermoon::povray_scenes
