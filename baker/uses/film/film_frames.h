// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Frame that was made.
struct MadeFrame {
  std::size_t frame;
  std::optional<Exposures> exposures;  ///< of its picture, where it has one
  bool developed_again = false;        ///< from a linear frame that was kept
};

/// Makes frames, as many at a time as memory and processors allow.
///
/// Given   film   with its light and its albedo
///         made   called with each frame once its files are there, from any thread, one call at a time
/// Throws  Error  the first of any frame; frames under way are abandoned
void make_frames(const Film& film, const std::vector<std::size_t>& frames,
                 const std::function<void(const MadeFrame&)>& made);

/// Writes the POV-Ray scene of all frames, beside their textures.
void write_film_scene(const Film& film);

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
