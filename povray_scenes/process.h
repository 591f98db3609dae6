// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "povray_scenes/render.h"

namespace coppermoon::povray_scenes {

/// The files that POV-Ray is writing under temporary names. The destructor removes those that are left.
struct Draft {
  std::filesystem::path folder;
  std::string stem;  ///< all temporary names begin with this

  /// Given   in     a folder that write_scene or write_sequence has filled
  /// Throws  Error  if there is no scene
  explicit Draft(const std::filesystem::path& in);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft();

  /// Gives a finished file its final name, replacing an earlier file.
  ///
  /// Given     ending  part of the temporary name after the stem
  /// Returned  the final path
  /// Throws    Error   if POV-Ray wrote no such file; the message blames the program `povray`
  std::filesystem::path finish(const std::string& ending, const std::string& name,
                               const std::string& povray) const;
};

/// One run of POV-Ray: what it renders, and the functions it calls.
struct Run {
  std::string output;                    ///< file name, which begins with the draft's stem
  std::vector<std::string> subset = {};  ///< part of an animation, such as +SF3, +EF5
  algebra::Progress progress = {};       ///< called with the fraction of the current frame, below 1
  /// Called when a frame of the subset begins, with its number, counted from 1; all earlier frames are then whole. May
  /// be empty, and may throw. It may be called twice for the same frame.
  std::function<void(std::size_t)> begun = {};
  /// Whether to stop POV-Ray once it has closed its output file, if the system can report that. Later messages and the
  /// exit status are then lost.
  bool until_closed = false;
  bool with_users_settings = false;  ///< also read povray.ini, for include paths
};

/// Runs POV-Ray in the draft's folder to its end, or until it has closed its output. POV-Ray does not outlive this
/// call, whether the call returns or throws, or the process is killed.
///
/// Throws  Error  if POV-Ray cannot be run, fails (with its last messages) or takes longer than allowed; also
///                whatever the callbacks throw
void run_povray(const RenderSettings& settings, const Draft& draft, const Run& run);

}  // namespace coppermoon::povray_scenes
