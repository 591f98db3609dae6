// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "povray_scenes/camera.h"
#include "uses/film/film.h"

namespace coppermoon::uses {

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
