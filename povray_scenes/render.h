// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "algebra/progress.h"

namespace coppermoon::povray_scenes {

/// Part of a picture. The column `right` and the row `bottom` are the first outside this part.
struct RenderWindow {
  std::size_t left, top, right, bottom;
};

/// Settings for a run of POV-Ray.
struct RenderSettings {
  int threads = 0;                ///< at most 512; 0 means one per processor
  double timeout_s = 0;           ///< time after which POV-Ray is stopped; 0 means never
  std::string povray = "povray";  ///< a program on the PATH, or an absolute path
  /// The part of the picture that is rendered, at least two pixels wide and high. The rest of the picture is black.
  std::optional<RenderWindow> window = {};
};

/// Runs `povray eclipse.ini` in a scene's folder.
///
/// Given     folder    filled by write_scene, with the texture added; its path may have spaces and any letters
///           progress  called with the fraction of pixels rendered, and with 1 when the frame is complete
/// Returned  the path of frame.exr, with scene-linear half floats. The file appears completely or not at all. POV-Ray
///           is stopped when the calling thread ends, even if the thread is killed
/// Accuracy  the pixels are bitwise identical with any number of threads, and in any window
/// Throws    Error  if there is no scene, or if POV-Ray is not installed, fails (with its last messages) or takes
///                  longer than allowed; an earlier frame.exr is then not changed
std::filesystem::path render(const std::filesystem::path& folder,
                             const RenderSettings& settings = {},
                             const algebra::Progress& progress = {});

/// Renders a frame and passes its file to a function that reads it. POV-Ray is killed as soon as it has closed the
/// file, because it would wait for a third of a second before it exits.
///
/// Given   read   reads the file, and must throw if it is incomplete, as on a full disk. The file is then removed
/// Throws  Error  in the same cases as render. Exceptions of `read` are passed on
void render_for(const std::function<void(const std::filesystem::path& exr)>& read,
                const std::filesystem::path& folder, const RenderSettings& settings = {},
                const algebra::Progress& progress = {});

/// A frame of a film with a scene that the user has written.
struct OwnScene {
  std::filesystem::path file;      ///< the scene; may refer to files in the same folder
  std::size_t width, height;       ///< [pixels]
  std::size_t frame, first, last;  ///< numbers of this frame, the film's first and its last
};

/// Renders one frame as part of a POV-Ray animation, anti-aliased as in write_scene. In the scene, `frame_number` is
/// the frame's number, and `clock` goes from 0 in the film's first frame to 1 in its last.
///
/// Given     folder  a new folder for this frame. POV-Ray searches for files that the scene refers to first in this
///                   folder, then in the scene's own, then where the user's povray.ini says
/// Returned  the path of frame.exr, scene-linear
/// Throws    Error   as for render; POV-Ray's messages call the scene's file scene.pov and its folder scene_folder
std::filesystem::path render_own(const std::filesystem::path& folder, const OwnScene& scene,
                                 const RenderSettings& settings = {});

}  // namespace coppermoon::povray_scenes
