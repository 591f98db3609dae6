// SPDX-License-Identifier: MIT
// Loaded before a program: its wall clock runs backwards, a day at a time.
#include <dlfcn.h>
#include <sys/time.h>

#include <ctime>

extern "C" {

int clock_gettime(clockid_t clock, timespec* at) noexcept {
  static time_t seconds = 0;
  using ClockGetTime = int (*)(clockid_t, timespec*);
  static const auto real = reinterpret_cast<ClockGetTime>(::dlsym(RTLD_NEXT, "clock_gettime"));
  const int done = real(clock, at);
  if (clock == CLOCK_REALTIME) at->tv_sec -= (seconds += 86400);
  return done;
}

int gettimeofday(timeval* at, void*) noexcept {
  timespec precise;
  clock_gettime(CLOCK_REALTIME, &precise);
  *at = {precise.tv_sec, precise.tv_nsec / 1000};
  return 0;
}

time_t time(time_t* at) noexcept {
  timespec precise;
  clock_gettime(CLOCK_REALTIME, &precise);
  if (at != nullptr) *at = precise.tv_sec;
  return precise.tv_sec;
}

}  // extern "C"
