// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// A frame that was made.
struct MadeFrame {
  std::size_t frame;
  std::optional<Exposures> exposures;  ///< of its picture, if it has one
  bool developed_again = false;        ///< developed from a linear frame that an earlier run left
};

/// Makes frames, as many at a time as memory and processors allow.
///
/// Given   film   with its light and its albedo
///         made   called with each frame once its files exist, from any thread, one call at a time
/// Throws  Error  the first error of any frame; frames under way are abandoned
void make_frames(const Film& film, const std::vector<std::size_t>& frames,
                 const std::function<void(const MadeFrame&)>& made);

/// Writes the POV-Ray scene of all frames, beside their textures.
void write_film_scene(const Film& film);

/// Callbacks while a film is being made, one call at a time; either may be empty.
struct FilmEvents {
  std::function<void(std::size_t frame)> kept = {};       ///< for a frame left by an earlier run
  std::function<void(const MadeFrame& frame)> made = {};  ///< for a frame made now, from any thread
};

/// The film with its ground: the albedo at the textures' size, so that no frame has to resize it.
///
/// Throws  Error  as normal_albedo
Film with_ground(Film film);

/// Makes those of the given frames that are missing, and the scene of all frames if the film has one. A frame is kept
/// if all its files exist, whole and made for this film.
///
/// Given   film   with its light; its folder must exist
/// Throws  Error  as make_frames, normal_albedo
void make_film(const Film& film, const std::vector<std::size_t>& frames,
               const FilmEvents& events = {});

}  // namespace coppermoon::uses
