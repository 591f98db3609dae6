// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "algebra/progress.h"
#include "povray_scenes/camera.h"
#include "povray_scenes/render.h"

namespace coppermoon::povray_scenes {

/// Name of a sequence's frames, before their number.
inline constexpr const char* frame_stem = "frame";

/// Moon in as many frames as there are cameras, a texture for each.
struct Sequence {
  std::vector<SceneCamera> cameras;  ///< all of the same width, height and field
  std::string textures;              ///< file name for numbered_file, beside the scene; plain ASCII
  bool alpha = false;                ///< as MoonScene's
  std::size_t first_frame = 1;       ///< number of the first frame and its texture

  std::size_t last_frame() const { return first_frame + cameras.size() - 1; }
};

/// Name of a numbered file of a sequence.
///
///     moon_lin_rec709.0007.exr        at least four digits, as many as the last frame has
std::string numbered_file(const std::string& stem, std::size_t frame, std::size_t last);

/// Text of one scene for all frames: places and texture are selected by POV-Ray's frame_number, never by its clock.
/// Frames count from first_frame; without an animation the first is rendered, past the last is an error.
///
/// Accuracy  a frame has the very pixels of its own single scene (see to_pov of that)
/// Throws    Error  as to_pov of a single scene, with the number of the frame; when there are no frames, a number
///                  beyond 999999, or a camera differs from the first one in width, height or field
std::string to_pov(const Sequence& sequence);

/// Text of POV-Ray's settings: those of a single scene, and the range of frames. Final_Frame is made of nines, which
/// gives frame.0001.exr four digits in a short sequence too: the last frame is Subset_End_Frame.
///
/// Throws  Error  as to_pov
std::string to_ini(const Sequence& sequence);

/// Writes eclipse.pov and eclipse.ini, each whole or not at all; with the textures put beside them,
/// `povray eclipse.ini` in that folder makes all frames, and `povray eclipse.ini +SF3 +EF5` three.
///
/// Given   folder  made when only its last part is missing
/// Throws  Error   as to_pov, before anything is written; or when the folder or a file cannot be made
void write_sequence(const std::filesystem::path& folder, const Sequence& sequence);

/// Callback for each frame whose file is whole.
using FrameDone = std::function<void(std::size_t frame, const std::filesystem::path& exr)>;

/// Renders frames in one run of POV-Ray.
///
/// Given     folder       as write_sequence left it, with the textures of these frames
///           first, last  from the sequence's first frame to its last
///           frame_done   called for each in order, on this thread, while POV-Ray goes on with the
///                        next; the file, frame.0001.exr in the folder, is the callee's to remove.
///                        What it throws ends POV-Ray and goes on from here
///           settings     the timeout is for the whole run, frame_done's own time included
///           progress     told the fraction of the pixels of the frame under way; 1 before each frame_done
/// Accuracy  the same bits as a run of its own for each frame, on any number of threads
/// Throws    Error  when the frames are out of range, there is no sequence, no POV-Ray, or it fails (with its own last
///                  words) or takes longer than allowed; the frames before have then been handed over
void render_sequence(const std::filesystem::path& folder, std::size_t first, std::size_t last,
                     const FrameDone& frame_done, const RenderSettings& settings = {},
                     const algebra::Progress& progress = {});

}  // namespace coppermoon::povray_scenes
