// SPDX-License-Identifier: MIT
#include "uses/film/film_times.h"

#include <fmt/format.h>

#include <cmath>

#include "algebra/error.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr double most_frames = 1e6;
constexpr std::size_t usual_frames = 240;

std::size_t count_of(const FilmTimes& times, double seconds) {
  if (times.frames && times.time_scale)
    throw algebra::Error(fmt::format("frames = {} and time-scale = {:g}, allowed one of the two",
                                     *times.frames, *times.time_scale));
  if (times.time_scale) {
    algebra::require_within("time scale", *times.time_scale, 1e-3, 1e6);
    const double count = std::floor(seconds * times.fps / *times.time_scale + 1e-6) + 1;
    algebra::require_within("frames", count, 1, most_frames);
    return static_cast<std::size_t>(count);
  }
  const auto frames = times.frames.value_or(usual_frames);
  algebra::require_within("frames", static_cast<double>(frames), 1, most_frames);
  return frames;
}

}  // namespace

std::string name_of(const eclipse::Eclipse& eclipse) {
  using enum eclipse::EclipseType;
  const auto day = almanac::utc_text(eclipse.greatest);
  const char* type = eclipse.type == total     ? "Total"
                     : eclipse.type == partial ? "Partial"
                                               : "Penumbral";
  return fmt::format("{} eclipse of the Moon, {}", type, day.substr(0, day.find('T')));
}

Moments moments_of(const FilmTimes& times) {
  algebra::require_within("fps", times.fps, 1, 1000);
  const double seconds = almanac::seconds_between(times.from, times.to);
  constexpr double longest = 86400;
  if (!(seconds >= 0 && seconds <= longest))
    throw algebra::Error(fmt::format("from {} to {} are {:.0f} s, allowed 0 to {:.0f}",
                                     almanac::utc_text(times.from), almanac::utc_text(times.to),
                                     seconds, longest));
  const auto count = count_of(times, seconds);
  double step = count > 1 ? seconds / static_cast<double>(count - 1) : 0;
  if (times.time_scale) step = *times.time_scale / times.fps;
  Moments moments{{}, times.eclipse};
  for (std::size_t i = 0; i < count; ++i)
    moments.frames.push_back(almanac::later(times.from, step * static_cast<double>(i)));
  return moments;
}

}  // namespace coppermoon::uses
