// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "uses/film/film.h"
#include "uses/film/film_frames.h"

namespace coppermoon::uses {

/// Callbacks while a film is made, one call at a time; either may be empty.
struct FilmEvents {
  std::function<void(std::size_t frame)> kept = {};       ///< for a frame that an earlier run left
  std::function<void(const MadeFrame& frame)> made = {};  ///< for a frame made now, from any thread
};

/// Film with its ground: the albedo at the textures' size, which no frame need resize again.
///
/// Throws  Error  as normal_albedo
Film with_ground(Film film);

/// Makes the missing ones of some frames, and the scene of all frames where the film has one. A frame is kept whose
/// files are all there, whole and of this film.
///
/// Given   film   with its light; its folder is there
/// Throws  Error  as make_frames, normal_albedo
void make_film(const Film& film, const std::vector<std::size_t>& frames,
               const FilmEvents& events = {});

}  // namespace coppermoon::uses
