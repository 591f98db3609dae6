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

/// Frames per second of a film: a ratio of whole numbers, such as 24/1 or 24000/1001.
struct FrameRate {
  int frames = 24, seconds = 1;

  double value() const { return static_cast<double>(frames) / seconds; }
};

/// Reads a frame rate.
///
/// Given     text  such as "24", "12.5" or "24000/1001"; a television rate as usually written, "23.976", "29.97" or
///                 "59.94", stands for the exact ratio with 1001
/// Returned  ratio in lowest terms; a decimal number is rounded to a thousandth
/// Throws    Error  when the text is not a frame rate, the rate is outside 1 to 1000, or a denominator exceeds 10000
FrameRate frame_rate_from(const std::string& text);

/// Text such as "24", "12.5" or "24000/1001", which frame_rate_from reads back.
std::string text_of(const FrameRate& rate);

/// Does what frame_rate_from does, in the form that request::parameter needs.
void read_text(const std::string& text, FrameRate& rate);

/// Request for the times of a film's frames.
struct FilmTimes {
  eclipse::Eclipse eclipse;
  almanac::Instant from, to;            ///< moments of the first and the last frame
  std::optional<std::size_t> frames{};  ///< number of frames, 1 to 1e6; if absent, 240
  FrameRate fps = {};                   ///< frames per second, 1 to 1000
  /// Seconds of the eclipse per second of the film, 1e-3 to 1e6. It can be given instead of the number of frames.
  std::optional<double> time_scale = {};
  std::optional<double> duration_s =
      {};  ///< length of the film [s], 1e-3 to 1e6; if `frames` is given too, both must agree
  /// Moments of the frames, in order of time, if the steps are not even. They replace all settings above except `fps`.
  std::vector<almanac::Instant> moments = {};
  std::size_t first_frame = 1;  ///< number of the first frame, 0 to 1e6
};

/// The moments of a film's frames, which are numbered consecutively, and the film's eclipse.
struct Moments {
  std::vector<almanac::Instant> frames;
  eclipse::Eclipse eclipse;
  std::size_t first_frame = 1;  ///< number of the first frame

  std::size_t last_frame() const { return first_frame + frames.size() - 1; }
  /// Moment of the frame with the given number.
  const almanac::Instant& at(std::size_t frame) const { return frames.at(frame - first_frame); }
};

/// The moments of a film's frames, either at even steps or as given in the request.
///
/// Throws  Error  when a number is outside its range, the last moment is before the first or more than a day after it,
///                or the given moments are not in order; when more than one of `frames`, `time_scale`, `duration_s`
///                and `moments` is given, unless `frames` and `duration_s` agree
Moments moments_of(const FilmTimes& times);

/// The part of an interval in which frames show at least some of the Moon, to a second. If the Moon sets and rises
/// again, this part ends when it first sets.
///
/// Throws  Error  when the Moon is below the horizon all the time
std::pair<almanac::Instant, almanac::Instant> while_up(const ViewRequest& view,
                                                       const almanac::Instant& from,
                                                       const almanac::Instant& to);

/// Reads frame numbers in the notation of render farms: "1-240", "1-240x2" (every second frame), "7,9,20-30". Each
/// number is returned once, in the order written.
///
/// Given   text   if empty, all frames are returned
///         count  number of frames in the film
///         first  number of the first frame
/// Throws  Error  for any other notation; for a frame outside the film
std::vector<std::size_t> frames_in(const std::string& text, std::size_t count,
                                   std::size_t first = 1);

/// The frames of shard K/N: every N-th frame, starting with the K-th.
std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, const Shard& shard);

}  // namespace coppermoon::uses
