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

}  // namespace coppermoon::uses
