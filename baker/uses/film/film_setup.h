// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "povray_scenes/scene_camera.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// How a film's camera is mounted.
enum class Mount {
  tracking,  ///< keeps the Moon in the middle; the view says which way is up
  horizon,   ///< keeps the Moon in the middle; the zenith is up
  fixed      ///< a tripod: the Moon moves across the picture; the zenith is up
};

struct Mounting {
  Mount mount = Mount::tracking;
  /// Direction in which a fixed camera points. If absent, it is the Moon's direction half-way through the film.
  std::optional<povray_scenes::HorizonPlace> aim = {};
};

/// Completes a film whose requests and moments are known. Sets the camera's view to suit its mount, and the texture
/// width for all frames, which is what the nearest Moon needs.
///
/// Given   frames  numbers of the frames to be made
/// Throws  Error   for everything that can be refused before any work: textures that POV-Ray cannot read, an invalid
///                 exposure or view, a fixed mount without an observer, an aim without a fixed mount, a Moon below the
///                 horizon in any of a few hundred frames (except in a user's scene), a path where no folder can be
///                 made, an albedo map that cannot be read; as require_scene
void set_up(Film& film, const Mounting& mounting, const std::vector<std::size_t>& frames);

/// How the Moon fits into the picture of a camera on a tripod, checked in a few hundred evenly spaced frames.
struct FixedView {
  std::size_t outside = 0;  ///< number of checked frames with part of the Moon outside the picture
  std::size_t looked_at =
      0;  ///< number of the checked frames in which the Moon is above the horizon
  /// Aim (to 0.1 degrees) and horizontal field (to a degree, not narrower than the film's) of a camera whose picture
  /// would hold the whole Moon in all checked frames. The aim is absent if there is no such camera or no need for one.
  std::optional<povray_scenes::HorizonPlace> aim = {};
  double field_deg = 0;
};

/// Given  film  completed by set_up, with an observer and an aim
FixedView fixed_view(const Film& film);

}  // namespace coppermoon::uses
