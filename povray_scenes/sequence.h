// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "povray_scenes/render.h"
#include "povray_scenes/scene_camera.h"

namespace coppermoon::povray_scenes {

/// The part of a frame's file name before its number.
inline constexpr const char* frame_stem = "frame";

/// The Moon in a series of frames, each with its own camera and texture.
struct Sequence {
  std::vector<SceneCamera> cameras;  ///< one for each frame, with equal width, height and field
  std::string textures;         ///< part of the textures' file names before the number; plain ASCII
  bool alpha = false;           ///< whether to add a channel A, as in MoonScene
  std::size_t first_frame = 1;  ///< number of the first frame and of its texture

  std::size_t last_frame() const { return first_frame + cameras.size() - 1; }
};

/// The name of a numbered file in a sequence.
///
///     moon_lin_rec709.0007.exr        as many digits as the last frame's number, but at least four
std::string numbered_file(const std::string& stem, std::size_t frame, std::size_t last);

/// The text of one scene for all frames. POV-Ray's frame_number, not its clock, selects the camera and the texture.
/// Frames are counted from first_frame. If POV-Ray does not render an animation, it renders the first frame. A number
/// above that of the last frame is an error.
///
/// Accuracy  each frame has exactly the same pixels as a MoonScene with the frame's camera and texture
/// Throws    Error  in the same cases as to_pov for a MoonScene, with the number of the frame; also if there are no
///                  frames, a number is above 999999, or a camera differs from the first one in width, height or field
std::string to_pov(const Sequence& sequence);

/// The text of POV-Ray's settings: those for a single scene, and the range of frames. Subset_End_Frame is the last
/// frame. Final_Frame consists of nines, so that names such as frame.0001.exr always have four digits or more.
///
/// Throws  Error  in the same cases as to_pov
std::string to_ini(const Sequence& sequence);

/// Writes eclipse.pov and eclipse.ini, each completely or not at all. When the textures are in the same folder, `povray
/// eclipse.ini` renders all frames there, and `povray eclipse.ini +SF3 +EF5` renders three of them.
///
/// Given   folder  created unless it exists; the folder that contains it must exist
/// Throws  Error   in the same cases as to_pov, before anything is written; or if a folder or file cannot be created
void write_sequence(const std::filesystem::path& folder, const Sequence& sequence);

/// A callback for each frame, called when the file of the frame is complete.
using FrameDone = std::function<void(std::size_t frame, const std::filesystem::path& exr)>;

/// Renders frames in one run of POV-Ray.
///
/// Given     folder       filled by write_sequence, with the textures of these frames added
///           first, last  numbers of the first and the last frame to be rendered
///           frame_done   called for each frame in order, on this thread, while POV-Ray continues with the next frame.
///                        The function may remove the frame's file, such as frame.0001.exr. If it throws, POV-Ray is
///                        killed and the exception is passed on
///           settings     the timeout is for the whole run, including the time that frame_done takes
/// Accuracy  the pixels are bitwise identical to those from a separate run for each frame, with any number of threads
/// Throws    Error  if the frames are out of range, if there is no sequence, or if POV-Ray is not installed, fails
///                  (with its last messages) or takes too long. Finished frames have then been passed to frame_done
void render_sequence(const std::filesystem::path& folder, std::size_t first, std::size_t last,
                     const FrameDone& frame_done, const RenderSettings& settings = {});

}  // namespace coppermoon::povray_scenes
