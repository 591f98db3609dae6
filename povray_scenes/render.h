// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "algebra/progress.h"

namespace coppermoon::povray_scenes {

/// Part of a picture. The columns `right` and the row `bottom` are the first outside it.
struct RenderWindow {
  std::size_t left, top, right, bottom;
};

/// Settings for a run of POV-Ray.
struct RenderSettings {
  int threads = 0;                ///< at most 512; 0 means one per processor
  double timeout_s = 0;           ///< POV-Ray is stopped after this time; 0 means never
  std::string povray = "povray";  ///< a program on the PATH, or an absolute path
  /// The part of the picture that is rendered, at least two pixels wide and high; the rest is black.
  std::optional<RenderWindow> window = {};
};

/// Runs `povray eclipse.ini` in a scene's folder.
///
/// Given     folder    filled by write_scene, with the texture; the path may have spaces and any letters
///           progress  called with the fraction of pixels rendered, and with 1 when the frame is complete
/// Returned  the path of frame.exr, scene-linear half floats; it appears whole or not at all.
///           POV-Ray does not outlive the calling thread, even if that is killed
/// Accuracy  the frame is the same to the bit on any number of threads, and in any window
/// Throws    Error  if there is no scene, POV-Ray is not installed, fails (with its last messages) or takes longer than
///                  allowed; an earlier frame.exr is then left as it was
std::filesystem::path render(const std::filesystem::path& folder,
                             const RenderSettings& settings = {},
                             const algebra::Progress& progress = {});

/// Renders a frame that is needed only once, to be read at once. POV-Ray is killed as soon as it has closed the file,
/// which saves the third of a second that it sleeps before it exits.
///
/// Given   read  reads the file, and throws if it is incomplete, as on a full disk; afterwards the file is removed
/// Throws  Error  like render; also whatever `read` throws
void render_for(const std::function<void(const std::filesystem::path& exr)>& read,
                const std::filesystem::path& folder, const RenderSettings& settings = {},
                const algebra::Progress& progress = {});

/// A frame of a film whose scene the user has written.
struct OwnScene {
  std::filesystem::path file;      ///< the scene; files that it names may be beside it
  std::size_t width, height;       ///< [pixels]
  std::size_t frame, first, last;  ///< this frame's number, the film's first and its last
};

/// Renders one frame as part of a POV-Ray animation, anti-aliased as in write_scene. In the scene, `frame_number` is
/// the frame's number, and `clock` goes from 0 in the film's first frame to 1 in its last.
///
/// Given     folder  new for this frame; POV-Ray looks for the files that the scene names first there, then beside the
///                   scene, then where the user's povray.ini says
/// Returned  the path of frame.exr, scene-linear
/// Throws    Error   like render; POV-Ray's messages call the scene's file scene.pov and its folder scene_folder
std::filesystem::path render_own(const std::filesystem::path& folder, const OwnScene& scene,
                                 const RenderSettings& settings = {});

}  // namespace coppermoon::povray_scenes
