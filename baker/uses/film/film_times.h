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
/// Returned  in lowest terms; a decimal number is rounded to a thousandth
/// Throws    Error  when the text is no frame rate, the rate is outside 1 to 1000, or a denominator exceeds 10000
FrameRate frame_rate_from(const std::string& text);

/// Text such as "24", "12.5" or "24000/1001", which frame_rate_from reads back.
std::string text_of(const FrameRate& rate);

/// Does what frame_rate_from does, in the form that request::parameter needs.
void read_text(const std::string& text, FrameRate& rate);

/// Request for the times of a film's frames.
struct FilmTimes {
  eclipse::Eclipse eclipse;
  almanac::Instant from, to;            ///< of the first and the last frame
  std::optional<std::size_t> frames{};  ///< their number, 1 to 1e6; if absent, 240
  FrameRate fps = {};                   ///< 1 to 1000
  /// seconds of the eclipse per second of the film, 1e-3 to 1e6, instead of the number of frames
  std::optional<double> time_scale = {};
  std::optional<double> duration_s =
      {};  ///< of the film, 1e-3 to 1e6; allowed beside the number of frames if both agree
  /// moments of the frames, increasing, instead of the five numbers above; if empty, even steps
  std::vector<almanac::Instant> moments = {};
  std::size_t first_frame = 1;  ///< number of the first frame, 0 to 1e6
};

/// Times of a film's frames, which are numbered one after another, and its eclipse.
struct Moments {
  std::vector<almanac::Instant> frames;
  eclipse::Eclipse eclipse;
  std::size_t first_frame = 1;  ///< number of the first frame

  std::size_t last_frame() const { return first_frame + frames.size() - 1; }
  /// Time of the frame with that number.
  const almanac::Instant& at(std::size_t frame) const { return frames.at(frame - first_frame); }
};

/// Times of a film's frames: at even steps, or the moments given.
///
/// Throws  Error  when a number is outside its range, the last moment is before the first or more than
///                a day after it, the moments are not in order, or any two of the moments, the number of frames,
///                the time scale and the duration disagree
Moments moments_of(const FilmTimes& times);

/// The interval between two moments in which frames show some of the Moon, to a second. If the Moon sets
/// and rises again, the interval ends when it sets.
///
/// Throws  Error  when the Moon is below the horizon all the time
std::pair<almanac::Instant, almanac::Instant> while_up(const ViewRequest& view,
                                                       const almanac::Instant& from,
                                                       const almanac::Instant& to);

/// Reads frame numbers in the notation of render farms: "1-240", "1-240x2" (every second one), "7,9,20-30". Each
/// appears once, in the order written.
///
/// Given   text   if empty, all frames
///         count  how many frames the film has
///         first  number of the first frame
/// Throws  Error  for any other notation; for a frame outside the film
std::vector<std::size_t> frames_in(const std::string& text, std::size_t count,
                                   std::size_t first = 1);

/// The frames of shard K/N: every N-th frame from the K-th on.
std::vector<std::size_t> part_of(const std::vector<std::size_t>& frames, const Shard& shard);

}  // namespace coppermoon::uses
