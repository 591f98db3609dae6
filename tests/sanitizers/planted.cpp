// SPDX-License-Identifier: MIT
// A fault of each kind that the sanitizers have to catch, planted: `planted overflow|leak|past_the_end`. Says "went on" when
// nothing ended it.
#include <climits>
#include <cstddef>
#include <cstdio>
#include <string_view>

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

}  // namespace

int main(int count, char** words) {
  const std::string_view fault = count > 1 ? words[1] : "";
  if (fault == "overflow") overflow(count);
  if (fault == "leak") leak(count);
  if (fault == "past_the_end") past_the_end(count);
  std::puts("went on");
}
