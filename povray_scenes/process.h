// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "povray_scenes/render.h"

namespace coppermoon::povray_scenes {

/// Files that POV-Ray writes under temporary names. The destructor removes the files that still have such names.
struct Draft {
  std::filesystem::path folder;
  std::string stem;  ///< beginning of all temporary names

  /// Given   in     folder filled by write_scene or write_sequence
  /// Throws  Error  if the folder has no scene
  explicit Draft(const std::filesystem::path& in);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft();

  /// Gives a finished file its final name, and replaces an earlier file of that name.
  ///
  /// Given     ending  part of the temporary name after the stem
  /// Returned  the path with the final name
  /// Throws    Error   if POV-Ray did not write the file; the message names the program `povray`
  std::filesystem::path finish(const std::string& ending, const std::string& name,
                               const std::string& povray) const;
};

/// One run of POV-Ray: what is rendered, and callbacks.
struct Run {
  std::string output;                    ///< name of the output file; begins with Draft::stem
  std::vector<std::string> subset = {};  ///< arguments for part of an animation, such as +SF3, +EF5
  algebra::Progress progress = {};       ///< called with the finished fraction of a frame, below 1
  /// Called with a frame's number in the subset, counted from 1, when POV-Ray begins this frame and has completed all
  /// earlier ones. The function may be empty, and may throw. It may be called twice for the same frame.
  std::function<void(std::size_t)> begun = {};
  /// Whether to stop POV-Ray as soon as it has closed its output file, if the system can report this. Later messages
  /// and the exit status are then lost.
  bool until_closed = false;
  bool with_users_settings = false;  ///< whether to read the user's povray.ini, for include paths
};

/// Runs POV-Ray in the draft's folder until it exits, or until it has closed its output file. POV-Ray is stopped when
/// this call ends, even if the call throws or this process is killed.
///
/// Throws  Error  if POV-Ray cannot be run, fails (with its last messages) or takes longer than allowed. Exceptions of
///                the callbacks are passed on
void run_povray(const RenderSettings& settings, const Draft& draft, const Run& run);

}  // namespace coppermoon::povray_scenes
