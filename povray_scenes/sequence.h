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
  std::vector<SceneCamera> cameras;  ///< one a frame, all of the same width, height and field
  std::string textures;         ///< the textures' file names up to the frame's number; plain ASCII
  bool alpha = false;           ///< as in MoonScene
  std::size_t first_frame = 1;  ///< number of the first frame and its texture

  std::size_t last_frame() const { return first_frame + cameras.size() - 1; }
};

/// The name of a numbered file in a sequence.
///
///     moon_lin_rec709.0007.exr        as many digits as the last frame's number, but at least four
std::string numbered_file(const std::string& stem, std::size_t frame, std::size_t last);

/// The text of one scene for all frames. POV-Ray's frame_number, not its clock, selects the camera and the texture.
/// Frames are counted from first_frame. Without an animation, POV-Ray renders the first frame. A number above the last
/// frame's is an error.
///
/// Accuracy  each frame has exactly the pixels of a single scene with its camera and texture (see to_pov for MoonScene)
/// Throws    Error  like to_pov for a single scene, with the number of the frame; also if there are no frames, a number
///                  is above 999999, or a camera differs from the first one in width, height or field
std::string to_pov(const Sequence& sequence);

/// The text of POV-Ray's settings: those for a single scene, and the range of frames. Final_Frame consists of nines, so
/// that names such as frame.0001.exr have four digits even in a short sequence. Subset_End_Frame is the last frame.
///
/// Throws  Error  like to_pov
std::string to_ini(const Sequence& sequence);

/// Writes eclipse.pov and eclipse.ini, each whole or not at all. Once the textures are beside them, `povray
/// eclipse.ini` in that folder renders all frames, and `povray eclipse.ini +SF3 +EF5` renders three of them.
///
/// Given   folder  created if only its last part is missing
/// Throws  Error   like to_pov, before anything is written; or if the folder or a file cannot be made
void write_sequence(const std::filesystem::path& folder, const Sequence& sequence);

/// A callback for each frame, called when the frame's file is complete.
using FrameDone = std::function<void(std::size_t frame, const std::filesystem::path& exr)>;

/// Renders frames in one run of POV-Ray.
///
/// Given     folder       filled by write_sequence, with the textures of these frames
///           first, last  numbers within the sequence, from its first frame to its last
///           frame_done   called for each frame in order, on this thread, while POV-Ray goes on with the next.
///                        It may remove the file, such as frame.0001.exr, which otherwise stays. If it throws,
///                        POV-Ray is killed and the exception passed on
///           settings     the timeout is for the whole run, including the time that frame_done takes
/// Accuracy  frames are the same to the bit as with a separate run for each, on any number of threads
/// Throws    Error  if the frames are out of range, there is no sequence, or POV-Ray is not installed, fails (with its
///                  last messages) or takes longer than allowed; earlier frames have then been passed to frame_done
void render_sequence(const std::filesystem::path& folder, std::size_t first, std::size_t last,
                     const FrameDone& frame_done, const RenderSettings& settings = {});

}  // namespace coppermoon::povray_scenes
