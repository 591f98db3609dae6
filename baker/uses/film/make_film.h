// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "uses/film/film.h"
#include "uses/film/film_frames.h"

namespace coppermoon::uses {

/// What a film tells while it is made, one call at a time; any may be empty.
struct FilmEvents {
  std::function<void(std::size_t frame)> kept = {};       ///< a frame that an earlier run left
  std::function<void(const MadeFrame& frame)> made = {};  ///< a frame, from any thread
};

/// Makes what is missing of some frames: frames whose files are all there, whole and of this film are
/// kept. The scene of all frames is written where the film has one.
///
/// Given   film   with its light; its folder is there
/// Throws  Error  as make_frames, normal_albedo
void make_film(const Film& film, const std::vector<std::size_t>& frames,
               const FilmEvents& told = {});

}  // namespace coppermoon::uses
