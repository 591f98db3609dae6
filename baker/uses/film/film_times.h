// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "almanac/instant.h"
#include "eclipse/contacts.h"
#include "uses/picture/view.h"

namespace coppermoon::uses {

/// When a film's frames are.
struct FilmTimes {
  eclipse::Eclipse eclipse;
  almanac::Instant from, to;            ///< moments of the first and of the last frame
  std::optional<std::size_t> frames{};  ///< number of frames, 1 to 1e6; without: 240
  double fps = 24;                      ///< frames in a second of the film, 1 to 1000
  std::optional<double> time_scale =
      {};  ///< seconds of the eclipse in a second of the film, 1e-3 to 1e6, instead of the number
};

/// A film's frames: the moment of each, and the eclipse it is of.
struct Moments {
  std::vector<almanac::Instant> frames;
  eclipse::Eclipse eclipse;
};

/// The moments of a film's frames, evenly from the first on.
///
/// Throws  Error  when a number is outside its range, the last moment is before the first or more than
///                a day after it, or the number of frames and the time scale are both given
Moments moments_of(const FilmTimes& times);

/// The first and the last moment between two at which the Moon is up, to a second: moonrise and moonset,
/// or the two moments themselves. A Moon that sets and rises between them is up until it sets.
///
/// Throws  Error  when it is below the horizon all the time
std::pair<almanac::Instant, almanac::Instant> while_up(const ViewRequest& view,
                                                       const almanac::Instant& from,
                                                       const almanac::Instant& to);

}  // namespace coppermoon::uses
