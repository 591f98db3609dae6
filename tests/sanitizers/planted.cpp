// SPDX-License-Identifier: MIT
// A fault of each kind that the sanitizers have to catch, planted: `planted overflow|leak|past_the_end|race`. Says "went on" when
// nothing ended it.
#include <atomic>
#include <climits>
#include <cstddef>
#include <cstdio>
#include <string_view>
#include <thread>

namespace {

/// Told at run time, so that no compiler sees the fault coming.
void overflow(int count) {
  volatile int most = INT_MAX;
  most = most + count;
}

void leak(int count) {
  auto* volatile lost = new double[static_cast<std::size_t>(count)];
  lost = nullptr;
}

void past_the_end(int count) {
  auto* volatile few = new double[static_cast<std::size_t>(count)];
  const double value = few[count];
  delete[] few;
  std::printf("%g\n", value);
}

/// One write after another, but nothing orders them: a relaxed flag does not.
void race(int count) {
  int shared = 0;
  std::atomic<bool> written = false;
  std::jthread other([&] {
    shared = count;
    written.store(true, std::memory_order_relaxed);
  });
  while (!written.load(std::memory_order_relaxed)) std::this_thread::yield();
  shared = -count;
}

}  // namespace

int main(int count, char** words) {
  const std::string_view fault = count > 1 ? words[1] : "";
  if (fault == "overflow") overflow(count);
  if (fault == "leak") leak(count);
  if (fault == "past_the_end") past_the_end(count);
  if (fault == "race") race(count);
  std::puts("went on");
}
