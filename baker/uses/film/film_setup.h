// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "povray_scenes/camera.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

/// What holds a film's camera.
enum class Mount {
  tracking,  ///< the Moon is in the picture's middle, and up is as the view says
  horizon,   ///< the Moon is in the picture's middle, and the zenith up
  fixed      ///< a tripod: the Moon goes through the picture, and the zenith is up
};

/// How a film's camera is held.
struct Mounting {
  Mount mount = Mount::tracking;
  /// where a fixed mount points, as seen; without: where the Moon is half way through the film
  std::optional<povray_scenes::HorizonPlace> aim = {};
};

/// Sets up a film of which the wishes and the moments are known: its view is that of its camera on its
/// mount, its textures have one width, as much as the frame needs where the Moon is nearest.
///
/// Given   frames  those that are to be made
/// Throws  Error   for all that can be refused before any work: textures that POV-Ray does not read,
///                 exposure and view that are not sound, a fixed mount without an observer, an aim
///                 without a fixed mount, a Moon below the horizon in any of a few hundred of the
///                 frames, a folder that cannot be, an albedo map that cannot be read
void set_up(Film& film, const Mounting& mounting, const std::vector<std::size_t>& frames);

}  // namespace coppermoon::uses
