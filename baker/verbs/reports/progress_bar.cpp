// SPDX-License-Identifier: MIT
#include "verbs/reports/progress_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "files/standard_streams.h"

namespace coppermoon::verbs {

using namespace std::chrono_literals;

ProgressBar::ProgressBar(std::string what)
    : what_(std::move(what)),
      on_terminal_(files::errors_on_terminal()),
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

AtWork::AtWork(std::string command, std::chrono::milliseconds first,
               std::chrono::milliseconds others)
    : command_(std::move(command)) {
  if (files::errors_on_terminal()) return;
  try {
    saying_ = std::thread([this, first, others] { say(first, others); });
  } catch (const std::system_error&) {  // if no thread can be started, nothing is printed
  }
}

AtWork::~AtWork() {
  if (!saying_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  end_.notify_one();
  saying_.join();
}

void AtWork::say(std::chrono::milliseconds first, std::chrono::milliseconds others) {
  std::unique_lock lock(mutex_);
  auto passed = first;
  for (auto wait = first; !end_.wait_for(lock, wait, [this] { return ended_; });
       wait = others, passed += others)
    fmt::print(stderr, "coppermoon: {}: at work for {:.0f} s\n", command_,
               std::chrono::duration<double>(passed).count());
}

}  // namespace coppermoon::verbs
