// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "povray_scenes/scene_camera.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// Mount of a film's camera.
enum class Mount {
  tracking,  ///< keeps the Moon in the middle; up is as in the view
  horizon,   ///< keeps the Moon in the middle; the zenith is up
  fixed      ///< tripod: the Moon crosses the picture; the zenith is up
};

/// A mount, and where it points.
struct Mounting {
  Mount mount = Mount::tracking;
  /// apparent direction of a fixed mount; if absent, the Moon's direction half-way through the film
  std::optional<povray_scenes::HorizonPlace> aim = {};
};

/// Completes a film whose requests and moments are known: sets the view of its camera on its mount, and one texture
/// width for all frames, as wide as the nearest Moon needs.
///
/// Given   frames  to be made
/// Throws  Error   for all that can be refused before any work: textures that POV-Ray cannot read, an invalid
///                 exposure or view, a fixed mount without an observer, an aim without a fixed mount, a Moon
///                 below the horizon in any of a few hundred frames unless there is a scene, a path where no
///                 folder can be, an albedo map that cannot be read; as require_scene
void set_up(Film& film, const Mounting& mounting, const std::vector<std::size_t>& frames);

/// How the Moons of a film fit into the picture of a camera on a tripod.
struct FixedView {
  std::size_t outside = 0;  ///< Moons that are not wholly in the picture
  std::size_t looked_at =
      0;  ///< Moons above the horizon in evenly spread frames: all frames of a film of 240
  /// Aim, and field across the picture, that take in all these Moons: in steps of 0.1 degrees and of one degree, the
  /// field not less than the film's own. Nothing if no picture holds them all.
  std::optional<povray_scenes::HorizonPlace> aim = {};
  double field_deg = 0;
};

/// Given  film  after set_up, with an observer and an aim
FixedView fixed_view(const Film& film);

}  // namespace coppermoon::uses
