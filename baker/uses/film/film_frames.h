// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// A frame that was made: its number, and how its picture was exposed, where it has one.
struct MadeFrame {
  std::size_t frame;
  std::optional<Exposures> exposures;
  bool developed_again = false;  ///< of a linear frame that was kept
};

/// Makes frames, some at a time, as memory and processors allow.
///
/// Given   film   with its light and its albedo
///         made   told each frame once its files are there, from any thread, one at a time
/// Throws  Error  the first that any frame met; those under way are then left
void make_frames(const Film& film, const std::vector<std::size_t>& frames,
                 const std::function<void(const MadeFrame&)>& made);

/// The POV-Ray scene of all frames, beside their textures.
void write_film_scene(const Film& film);

}  // namespace coppermoon::uses
