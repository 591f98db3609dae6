// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "uses/film/frame_rate.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

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

}  // namespace coppermoon::uses
