// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "algebra/progress.h"

namespace coppermoon::verbs {

/// Progress bar on stderr that exists as long as this object. It appears only on a terminal, and only after a second.
class ProgressBar {
 public:
  explicit ProgressBar(std::string what);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Callback to pass to a function that reports its progress. It must not outlive the bar.
  algebra::Progress progress();

 private:
  void draw(double fraction);

  std::string what_;
  bool on_terminal_, drawn_ = false;
  std::chrono::steady_clock::time_point next_;
  std::mutex mutex_;
};

/// Prints on stderr that a command is still at work, as long as this object exists: first after ten seconds, then once
/// a minute. Prints nothing on a terminal.
class AtWork {
 public:
  /// Given  first   time until the first line is printed
  ///        others  time between later lines
  explicit AtWork(std::string command, std::chrono::milliseconds first = std::chrono::seconds(10),
                  std::chrono::milliseconds others = std::chrono::minutes(1));
  ~AtWork();
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  /// Body of the thread. Allocates no memory before it prints, because a thread's first allocation reserves 64 MB.
  void say(std::chrono::milliseconds first, std::chrono::milliseconds others);

  std::string command_;
  bool ended_ = false;
  std::mutex mutex_;
  std::condition_variable end_;
  std::thread saying_;
};

}  // namespace coppermoon::verbs
