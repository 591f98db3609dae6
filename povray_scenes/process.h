// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "povray_scenes/render.h"

namespace coppermoon::povray_scenes {

/// The files of frames that POV-Ray is still writing, under names of their own; none is left
/// behind.
struct Draft {
  std::filesystem::path folder;
  std::string stem;  ///< of all that POV-Ray writes

  /// Given   in    a folder that write_scene or write_sequence left
  /// Throws  Error  when there is no scene
  explicit Draft(const std::filesystem::path& in);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  ~Draft();

  /// Gives a whole file its name in the folder, in place of an earlier one.
  ///
  /// Given     ending  of the draft's name, after the stem
  /// Returned  the path
  /// Throws    Error   when POV-Ray wrote no such file; `povray` is the program blamed
  std::filesystem::path finish(const std::string& ending, const std::string& name,
                               const std::string& povray) const;
};

/// What POV-Ray is to be asked for, and who is told what it says.
struct Run {
  std::string output;                    ///< the name of its file, of the draft's stem
  std::vector<std::string> subset = {};  ///< of an animation: +SF3, +EF5
  algebra::Progress progress = {};       ///< within the frame under way, below 1
  /// Told that this frame of the subset begins, from 1: those before are whole. May be empty, may
  /// be told twice, and may throw.
  std::function<void(std::size_t)> begun = {};
  /// Ends POV-Ray once it has closed its output, where the system tells of that: its words and exit status
  /// after that are not waited for, nor known.
  bool until_closed = false;
};

/// Runs POV-Ray in the draft's folder to its end, or until it has closed its output. It does not outlive this call, whether that
/// returns, throws, or the process is killed.
///
/// Throws  Error  when it cannot be run, fails (with its own last words) or takes longer than
///                allowed; also what is thrown by those who are told
void run_povray(const RenderSettings& settings, const Draft& draft, const Run& run);

}  // namespace coppermoon::povray_scenes
