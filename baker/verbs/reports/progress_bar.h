// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "algebra/progress.h"

namespace coppermoon::verbs {

/// Progress bar on stderr for as long as it lives: on a terminal alone, and once a second has passed.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Callback for a function that reports its progress; must not outlive the bar.
  algebra::Progress progress();

 private:
  void draw(double fraction);

  std::string what_;
  bool on_terminal_, drawn_ = false;
  std::chrono::steady_clock::time_point next_;
  std::mutex mutex_;
};

}  // namespace coppermoon::verbs
