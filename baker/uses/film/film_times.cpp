// SPDX-License-Identifier: MIT
#include "uses/film/film_times.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "algebra/error.h"
#include "algebra/number.h"
#include "atmosphere/astronomical_refraction.h"

namespace coppermoon::uses {
namespace {

using almanac::Instant;

constexpr double most_frames = 1e6;
constexpr std::size_t usual_frames = 240;

std::size_t count_in(double duration_s, const FrameRate& fps) {
  algebra::require_within("duration [s]", duration_s, 1e-3, 1e6);
  const double count = std::max(1., std::round(duration_s * fps.value()));
  algebra::require_within("frames", count, 1, most_frames);
  return static_cast<std::size_t>(count);
}

/// Refuses a request with more than one rule for the number of frames, unless the number agrees with the duration.
void require_one_rule(const FilmTimes& times) {
  std::vector<std::string> given;
  const bool both = times.frames && times.duration_s && !times.time_scale && times.moments.empty();
  if (both && *times.frames == count_in(*times.duration_s, times.fps)) return;
  if (both)
    throw algebra::Error(
        fmt::format("frames = {} and duration = {:g} s, allowed one of the two, or the {} frames "
                    "that {:g} s have at {} frames per second",
                    *times.frames, *times.duration_s, count_in(*times.duration_s, times.fps),
                    *times.duration_s, text_of(times.fps)));
  if (!times.moments.empty()) given.push_back(fmt::format("{} moments", times.moments.size()));
  if (times.frames) given.push_back(fmt::format("frames = {}", *times.frames));
  if (times.time_scale) given.push_back(fmt::format("time-scale = {:g}", *times.time_scale));
  if (times.duration_s) given.push_back(fmt::format("duration = {:g}", *times.duration_s));
  if (given.size() > 1)
    throw algebra::Error(fmt::format("{}, allowed one of the {}", fmt::join(given, " and "),
                                     given.size() == 2 ? "two" : "rules"));
}

std::size_t count_of(const FilmTimes& times, double seconds) {
  if (times.duration_s) return count_in(*times.duration_s, times.fps);
  if (times.time_scale) {
    algebra::require_within("time scale", *times.time_scale, 1e-3, 1e6);
    const double count = std::floor(seconds * times.fps.value() / *times.time_scale + 1e-6) + 1;
    algebra::require_within("frames", count, 1, most_frames);
    return static_cast<std::size_t>(count);
  }
  const auto frames = times.frames.value_or(usual_frames);
  algebra::require_within("frames", static_cast<double>(frames), 1, most_frames);
  return frames;
}

/// Whether a frame shows some of the Moon. Some is shown if the Moon's centre is less than 0.17 degrees below the
/// horizon, because the flattened disc's radius is at least 0.2 degrees. Without an observer, always true.
bool is_seen(const ViewRequest& view, const almanac::SkyState& sky) {
  if (!view.observer || !moon_is_up(view, sky)) return !view.observer;
  const auto horizon = atmosphere::apparent_altitude(horizon_altitude(*view.observer));
  return algebra::in_degrees(apparent_place(*view.observer, sky).altitude - horizon) > -0.17;
}

/// Finds moonrise or moonset, to a second, between `up`, when the Moon is seen, and `down`, when it is not. The Moon is
/// seen at the moment that is returned.
Instant edge_of(const ViewRequest& view, Instant up, Instant down) {
  while (std::abs(almanac::seconds_between(up, down)) > 1) {
    const auto middle = almanac::later(up, almanac::seconds_between(up, down) / 2);
    (is_seen(view, almanac::sky_at(middle)) ? up : down) = middle;
  }
  return up;
}

constexpr double least = 1, most = 1000;
constexpr int most_below = 10000, television = 1001, thousand = 1000;

FrameRate reduced(int over, int under) {
  const int common = std::gcd(over, under);
  return {over / common, under / common};
}

/// A decimal frame rate as a ratio. Television rates, which are 1000/1001 times multiples of 12 or 15, are recognised
/// when written with two or three decimals.
FrameRate ratio_of(double number) {
  constexpr double written_within = 0.005;
  const long whole = std::lround(number * television / thousand);
  const bool is_whole = number == std::round(number),
             near = std::abs(number - static_cast<double>(whole) * thousand / television) <
                    written_within;
  if (!is_whole && near && (whole % 12 == 0 || whole % 15 == 0))
    return reduced(static_cast<int>(whole) * thousand, television);
  return reduced(static_cast<int>(std::lround(number * thousand)), thousand);
}

struct Run {
  std::size_t from, to, step;
};

std::optional<Run> run_from(const std::string& text) {
  const auto cross = text.find('x');
  const auto ends = text.substr(0, cross);
  const auto dash = ends.find('-');
  const auto from = algebra::whole_number(ends.substr(0, dash)),
             to = dash == std::string::npos ? from : algebra::whole_number(ends.substr(dash + 1)),
             step = cross == std::string::npos ? 1 : algebra::whole_number(text.substr(cross + 1));
  if (!from || !to || !step || *step == 0 || *to < *from) return std::nullopt;
  return Run{*from, *to, *step};
}

}  // namespace

std::pair<Instant, Instant> while_up(const ViewRequest& view, const Instant& from,
                                     const Instant& to) {
  constexpr double step_s = 300;
  const double seconds = almanac::seconds_between(from, to);
  std::optional<std::pair<Instant, Instant>> found;
  Instant before = from;
  for (double passed = 0; passed < seconds + step_s; passed += step_s) {
    const auto now = almanac::later(from, std::min(passed, seconds));
    const bool up = is_seen(view, almanac::sky_at(now));
    if (up && !found) found = {passed == 0 ? from : edge_of(view, now, before), now};
    if (up) found->second = now;
    if (!up && found) return {found->first, edge_of(view, before, now)};
    before = now;
  }
  if (!found)
    throw algebra::Error(fmt::format("the Moon is below the horizon of {} from {} to {}",
                                     place_text(*view.observer), almanac::utc_text(from),
                                     almanac::utc_text(to)));
  return *found;
}

Moments moments_of(const FilmTimes& times) {
  algebra::require_within("fps", times.fps.value(), 1, 1000);
  algebra::require_within("first frame", static_cast<double>(times.first_frame), 0, most_frames);
  require_one_rule(times);
  const auto& moments_given = times.moments;
  for (std::size_t i = 1; i < moments_given.size(); ++i)
    if (almanac::seconds_between(moments_given[i - 1], moments_given[i]) <= 0)
      throw algebra::Error(fmt::format("moments = {} after {}, allowed in order of time",
                                       almanac::utc_text(moments_given[i]),
                                       almanac::utc_text(moments_given[i - 1])));
  const auto from = moments_given.empty() ? times.from : moments_given.front(),
             to = moments_given.empty() ? times.to : moments_given.back();
  const double seconds = almanac::seconds_between(from, to);
  constexpr double longest = 86400;
  if (!(seconds >= 0 && seconds <= longest))
    throw algebra::Error(fmt::format("from {} to {} are {:.0f} s, allowed 0 to {:.0f}",
                                     almanac::utc_text(from), almanac::utc_text(to), seconds,
                                     longest));
  if (!moments_given.empty()) return {moments_given, times.eclipse, times.first_frame};
  const auto count = count_of(times, seconds);
  double step = count > 1 ? seconds / static_cast<double>(count - 1) : 0;
  if (times.time_scale) step = *times.time_scale / times.fps.value();
  Moments moments{{}, times.eclipse, times.first_frame};
  for (std::size_t i = 0; i < count; ++i)
    moments.frames.push_back(almanac::later(times.from, step * static_cast<double>(i)));
  return moments;
}

FrameRate frame_rate_from(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) {
    const auto number = algebra::number_in(text);
    if (!number)
      throw algebra::Error(
          fmt::format("fps = {}, allowed 1 to 1000, as 24, 23.976 or 24000/1001", text));
    algebra::require_within("fps", *number, least, most);
    return ratio_of(*number);
  }
  const auto over = algebra::whole_number(text.substr(0, slash)),
             under = algebra::whole_number(text.substr(slash + 1));
  const bool sound = over && under && *under >= 1 && *under <= most_below && *over >= *under &&
                     *over <= thousand * *under;
  if (!sound)
    throw algebra::Error(fmt::format(
        "fps = {}, allowed 1 to 1000, a ratio of whole numbers with 1 to 10000 below", text));
  return reduced(static_cast<int>(*over), static_cast<int>(*under));
}

std::string text_of(const FrameRate& rate) {
  return thousand % rate.seconds == 0 ? fmt::format("{}", rate.value())
                                      : fmt::format("{}/{}", rate.frames, rate.seconds);
}

void read_text(const std::string& text, FrameRate& rate) { rate = frame_rate_from(text); }

std::vector<std::size_t> frames_in(const std::string& text, std::size_t count, std::size_t first) {
  const auto last = first + count - 1;
  const auto all = fmt::format("{}-{}", first, last);
  std::vector<std::size_t> frames;
  std::vector<bool> taken(count);
  std::istringstream parts(text.empty() ? all : text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto run = run_from(part);
    if (!run || run->from < first || run->to > last)
      throw algebra::Error(fmt::format(
          "range = {}, allowed frames of {}, as 1-240, 1-240x2 or 7,9,20-30", text, all));
    for (std::size_t frame = run->from; frame <= run->to; frame += run->step) {
      if (!taken[frame - first]) frames.push_back(frame);
      taken[frame - first] = true;
    }
  }
  return frames;
}

std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, const Shard& shard) {
  std::vector<std::size_t> mine;
  for (std::size_t i = shard.part - 1; i < frames.size(); i += shard.parts)
    mine.push_back(frames[i]);
  return mine;
}

}  // namespace coppermoon::uses
