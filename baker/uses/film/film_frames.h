// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

struct MadeFrame {
  std::size_t frame;
  std::optional<Exposures> exposures;  ///< exposures used; absent if only a texture was made
  bool developed_again = false;        ///< whether developed from an earlier run's linear frame
};

/// Makes frames, as many at a time as memory and processors allow.
///
/// Given   film   its light and albedo must be set
///         made   called for each frame once its files exist; called from any thread, but one call at a time
/// Throws  Error  the first error in any frame, after abandoning the frames that are being made
void make_frames(const Film& film, const std::vector<std::size_t>& frames,
                 const std::function<void(const MadeFrame&)>& made);

/// Writes the POV-Ray scene for all frames into the folder of their textures.
void write_film_scene(const Film& film);

/// Callbacks while a film is being made. They are called one at a time, and either may be empty.
struct FilmEvents {
  std::function<void(std::size_t frame)> kept = {};       ///< called for a frame of an earlier run
  std::function<void(const MadeFrame& frame)> made = {};  ///< called for a new frame, on any thread
};

/// Adds to a film the Moon's maps of albedo (at the textures' resolution, so no frame resizes it), colour and surge.
///
/// Throws  Error  as normal_albedo
Film with_ground(Film film);

/// Makes those of the given frames that are missing, and the POV-Ray scene if it is one of the film's products. A frame
/// is kept if all its files exist, are undamaged, and were made for this film.
///
/// Given   film   its light must be set, and its folder must exist
/// Throws  Error  as make_frames, normal_albedo
void make_film(const Film& film, const std::vector<std::size_t>& frames,
               const FilmEvents& events = {});

}  // namespace coppermoon::uses
