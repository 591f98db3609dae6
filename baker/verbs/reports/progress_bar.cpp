// SPDX-License-Identifier: MIT
#include "verbs/reports/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace coppermoon::verbs {

using namespace std::chrono_literals;

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      next_(std::chrono::steady_clock::now() + 1s) {}

ProgressBar::~ProgressBar() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
}

algebra::Progress ProgressBar::progress() {
  if (!on_terminal_) return {};
  return [this](double fraction) { draw(fraction); };
}

void ProgressBar::draw(double fraction) {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (now < next_) return;
  constexpr int width = 30;
  const auto filled = static_cast<int>(std::clamp(fraction, 0., 1.) * width);
  fmt::print(stderr, "\r{:<12} [{:<{}}] {:3.0f} %", what_,
             std::string(static_cast<std::size_t>(filled), '='), width, 100 * fraction);
  std::fflush(stderr);
  drawn_ = true;
  next_ = now + 100ms;
}

}  // namespace coppermoon::verbs
