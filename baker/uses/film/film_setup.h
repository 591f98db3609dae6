// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "povray_scenes/camera.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// Mount of a film's camera.
enum class Mount {
  tracking,  ///< keeps the Moon in the middle; up as the view has it
  horizon,   ///< keeps the Moon in the middle; the zenith up
  fixed      ///< tripod: the Moon crosses the picture; the zenith up
};

/// Mount, and where it points.
struct Mounting {
  Mount mount = Mount::tracking;
  /// apparent direction of a fixed mount; without: the Moon's half way through the film
  std::optional<povray_scenes::HorizonPlace> aim = {};
};

/// Completes a film whose requests and moments are known: the view of its camera on its mount, and one texture width
/// for all frames, as wide as the nearest Moon needs.
///
/// Given   frames  to be made
/// Throws  Error   for all that can be refused before any work: textures that POV-Ray does not read, an unsound
///                 exposure or view, a fixed mount without an observer, an aim without a fixed mount, a Moon
///                 below the horizon in any of a few hundred frames, unless there is a scene; as require_scene; a path where no folder can be, an albedo
///                 map that cannot be read
void set_up(Film& film, const Mounting& mounting, const std::vector<std::size_t>& frames);

/// Moons in the picture of a camera on a tripod.
struct FixedView {
  std::size_t outside = 0;  ///< Moons that the picture does not hold whole
  std::size_t looked_at =
      0;  ///< Moons above the horizon, of frames spread evenly: all of a film of 240
  /// aim, and field across the picture, that hold all of them: in steps of 0.1 degrees and of a degree, not less than
  /// the film's own field. None where no picture holds them
  std::optional<povray_scenes::HorizonPlace> aim = {};
  double field_deg = 0;
};

/// Given  film  after set_up, of an observer and an aim
FixedView fixed_view(const Film& film);

}  // namespace coppermoon::uses
