// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Multiple exposure: the sum of scene-linear frames, each exposed as its header says, developed as one picture.
///
///     value = Σ s L        s: exposure_scale of the frame
///
/// Of frames that hold a sky it is the greatest s L in each pixel, as photographers blend by lightening: a sum would hold
/// many skies.
///
/// Omits   occultation where Moons overlap
/// Throws  Error  when a frame cannot be read, differs in size from the first, or has no exposure in its header
void write_composite(const std::filesystem::path& path, const Film& film,
                     const std::vector<std::size_t>& frames);

}  // namespace coppermoon::uses
