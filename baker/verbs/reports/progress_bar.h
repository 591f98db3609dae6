// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

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

/// Lines on stderr, for as long as it lives, that a command is at work: after ten seconds and then once a minute. On a
/// terminal there are none.
class AtWork {
 public:
  /// Given  waits  before the first line and between others
  explicit AtWork(std::string command, std::chrono::milliseconds first = std::chrono::seconds(10),
                  std::chrono::milliseconds others = std::chrono::minutes(1));
  ~AtWork();
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  /// Asks for no memory before there is something to say: a thread's first would take 64 MB of addresses.
  void say(std::chrono::milliseconds first, std::chrono::milliseconds others);

  std::string command_;
  bool ended_ = false;
  std::mutex mutex_;
  std::condition_variable end_;
  std::thread saying_;
};

}  // namespace coppermoon::verbs
