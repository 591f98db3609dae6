// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "povray_scenes/render.h"

namespace coppermoon::povray_scenes {

/// Files that POV-Ray is still writing, under temporary names; none is left behind.
struct Draft {
  std::filesystem::path folder;
  std::string stem;  ///< of all temporary names

  /// Given   in    a folder that write_scene or write_sequence left
  /// Throws  Error  when there is no scene
  explicit Draft(const std::filesystem::path& in);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft();

  /// Renames a finished file, replacing an earlier one.
  ///
  /// Given     ending  of the draft's name, after the stem
  /// Returned  the path
  /// Throws    Error   when POV-Ray wrote no such file; `povray` is the program blamed
  std::filesystem::path finish(const std::string& ending, const std::string& name,
                               const std::string& povray) const;
};

/// One run of POV-Ray: what it renders, and callbacks.
struct Run {
  std::string output;                    ///< file name, beginning with the draft's stem
  std::vector<std::string> subset = {};  ///< of an animation: +SF3, +EF5
  algebra::Progress progress = {};       ///< within the frame under way, below 1
  /// Called when a frame of the subset begins, counted from 1: those before are whole. May be empty, is perhaps
  /// called twice, and may throw.
  std::function<void(std::size_t)> begun = {};
  /// Ends POV-Ray once it has closed its output, where the system reports that; later messages and the exit status
  /// are then lost.
  bool until_closed = false;
  bool with_users_settings = false;  ///< povray.ini counts too, which says where includes are
};

/// Runs POV-Ray in the draft's folder to its end, or until it has closed its output. POV-Ray does not outlive this
/// call, whether that returns, throws, or the process is killed.
///
/// Throws  Error  when it cannot be run, fails (with its own last words) or takes longer than
///                allowed; also what the callbacks throw
void run_povray(const RenderSettings& settings, const Draft& draft, const Run& run);

}  // namespace coppermoon::povray_scenes
