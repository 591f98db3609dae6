// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "uses/light/shard.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// Frames in a second of a film: a ratio of whole numbers, as 24/1 or 24000/1001.
struct FrameRate {
  int frames = 24, seconds = 1;

  double value() const { return static_cast<double>(frames) / seconds; }
};

/// Frame rate of a text.
///
/// Given     text  "24", "12.5" or "24000/1001"; a television rate as it is mostly written, "23.976", "29.97" or
///                 "59.94", is the ratio with 1001 that is meant
/// Returned  in lowest terms; a decimal number is rounded to a thousandth
/// Throws    Error  when it is none, or outside 1 to 1000; for a ratio with more than 10000 below
FrameRate frame_rate_from(const std::string& text);

/// "24", "12.5", "24000/1001": frame_rate_from reads it back.
std::string text_of(const FrameRate& rate);

/// As frame_rate_from, for request::parameter.
void read_text(const std::string& text, FrameRate& rate);

/// Request for the times of a film's frames.
struct FilmTimes {
  eclipse::Eclipse eclipse;
  almanac::Instant from, to;            ///< of the first and the last frame
  std::optional<std::size_t> frames{};  ///< their number, 1 to 1e6; without: 240
  FrameRate fps = {};                   ///< 1 to 1000
  /// seconds of the eclipse in a second of the film, 1e-3 to 1e6, in place of the number of frames
  std::optional<double> time_scale = {};
  std::optional<double> duration_s =
      {};  ///< of the film, 1e-3 to 1e6; beside the number of frames where both agree
  /// moments of the frames, increasing, in place of the five numbers above; empty: even steps
  std::vector<almanac::Instant> moments = {};
  std::size_t first_frame = 1;  ///< number of the first frame, 0 to 1e6
};

/// Times of a film's frames, which are numbered one after another, and its eclipse.
struct Moments {
  std::vector<almanac::Instant> frames;
  eclipse::Eclipse eclipse;
  std::size_t first_frame = 1;  ///< number of the first

  std::size_t last_frame() const { return first_frame + frames.size() - 1; }
  /// Time of the frame of that number.
  const almanac::Instant& at(std::size_t frame) const { return frames.at(frame - first_frame); }
};

/// Times of a film's frames: at even steps, or the moments given.
///
/// Throws  Error  when a number is outside its range, the last moment is before the first or more than
///                a day after it, moments are not in order, or two of moments, number of frames, time scale and
///                duration are given that disagree
Moments moments_of(const FilmTimes& times);

/// Interval between two moments in which frames show some of the Moon, to a second. Of a Moon that sets
/// and rises again: until it sets.
///
/// Throws  Error  when it is below the horizon all the time
std::pair<almanac::Instant, almanac::Instant> while_up(const ViewRequest& view,
                                                       const almanac::Instant& from,
                                                       const almanac::Instant& to);

/// Frames of a range in the notation of render farms: "1-240", "1-240x2" (every second), "7,9,20-30". Each stands
/// once, in the order written.
///
/// Given   text   empty: all
///         count  number of the film's frames
///         first  number of the first
/// Throws  Error  for another notation; for a frame beyond the film
std::vector<std::size_t> frames_in(const std::string& text, std::size_t count,
                                   std::size_t first = 1);

/// Share of shard K/N: every N-th frame from the K-th on.
std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, const Shard& shard);

}  // namespace coppermoon::uses
