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

/// The Moon in as many frames as there are cameras, with one texture for each.
struct Sequence {
  std::vector<SceneCamera> cameras;  ///< all of the same width, height and field
  std::string textures;              ///< file name for numbered_file, beside the scene; plain ASCII
  bool alpha = false;                ///< as in MoonScene
  std::size_t first_frame = 1;       ///< number of the first frame and its texture

  std::size_t last_frame() const { return first_frame + cameras.size() - 1; }
};

/// The name of a numbered file in a sequence.
///
///     moon_lin_rec709.0007.exr        as many digits as the last frame's number, but at least four
std::string numbered_file(const std::string& stem, std::size_t frame, std::size_t last);

/// The text of one scene for all frames. POV-Ray's frame_number, never its clock, selects places and texture. Frames
/// are counted from first_frame. Without an animation POV-Ray renders the first; a frame past the last is an error.
///
/// Accuracy  a frame has exactly the pixels that a single scene of it would have (see to_pov for MoonScene)
/// Throws    Error  like to_pov for a single scene, with the number of the frame; also if there are no frames, a number
///                  is above 999999, or a camera differs from the first one in width, height or field
std::string to_pov(const Sequence& sequence);

/// The text of POV-Ray's settings: those for a single scene, and the range of frames. Final_Frame is all nines, so that
/// even in a short sequence frame.0001.exr has four digits. The real last frame is Subset_End_Frame.
///
/// Throws  Error  like to_pov
std::string to_ini(const Sequence& sequence);

/// Writes eclipse.pov and eclipse.ini, each whole or not at all; with the textures put beside them,
/// `povray eclipse.ini` in that folder makes all frames, and `povray eclipse.ini +SF3 +EF5` makes three of them.
///
/// Given   folder  created if only its last part is missing
/// Throws  Error   like to_pov, before anything is written; or if the folder or a file cannot be made
void write_sequence(const std::filesystem::path& folder, const Sequence& sequence);

/// Callback for each frame whose file is whole.
using FrameDone = std::function<void(std::size_t frame, const std::filesystem::path& exr)>;

/// Renders frames in one run of POV-Ray.
///
/// Given     folder       as write_sequence left it, with the textures of these frames
///           first, last  numbers within the sequence, from its first frame to its last
///           frame_done   called for each frame in order, on this thread, while POV-Ray goes on with the next.
///                        Removing the file, such as frame.0001.exr, is left to it. If it throws, POV-Ray is
///                        ended and the exception passed on
///           settings     the timeout is for the whole run, including the time that frame_done takes
/// Accuracy  the same bits as with a separate run for each frame, on any number of threads
/// Throws    Error  if the frames are out of range, there is no sequence or no POV-Ray, or POV-Ray fails (with its last
///                  messages) or takes longer than allowed; earlier frames have then been handed over
void render_sequence(const std::filesystem::path& folder, std::size_t first, std::size_t last,
                     const FrameDone& frame_done, const RenderSettings& settings = {});

}  // namespace coppermoon::povray_scenes
