// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "povray_scenes/render.h"

namespace coppermoon::povray_scenes {

/// The files that POV-Ray is still writing, under temporary names. None of them is left behind.
struct Draft {
  std::filesystem::path folder;
  std::string stem;  ///< begins all temporary names

  /// Given   in     a folder that write_scene or write_sequence has filled
  /// Throws  Error  if there is no scene
  explicit Draft(const std::filesystem::path& in);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft();

  /// Gives a finished file its final name, replacing an earlier file.
  ///
  /// Given     ending  what follows the stem in the draft's name
  /// Returned  the path
  /// Throws    Error   if POV-Ray wrote no such file; the message blames the program `povray`
  std::filesystem::path finish(const std::string& ending, const std::string& name,
                               const std::string& povray) const;
};

/// One run of POV-Ray: what it renders, and the callbacks.
struct Run {
  std::string output;                    ///< file name, beginning with the draft's stem
  std::vector<std::string> subset = {};  ///< part of an animation: +SF3, +EF5
  algebra::Progress progress = {};       ///< within the current frame, below 1
  /// Called when a frame of the subset begins, counted from 1; all frames before it are whole. May be empty, may be
  /// called twice for a frame, and may throw.
  std::function<void(std::size_t)> begun = {};
  /// Ends POV-Ray once it has closed its output, if the system can report that. Later messages and the exit status are
  /// then lost.
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
