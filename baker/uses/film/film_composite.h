// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// A multiple exposure: the film's scene-linear frames, each as long as its own header says, on one
/// picture, which is then developed.
///
///     value = Σ s L        s: exposure_scale of the frame
///
/// Omits   that Moons which overlap hide one another
/// Throws  Error  when a frame cannot be read, differs in size from the first, or tells no exposure
void write_composite(const std::filesystem::path& path, const Film& film,
                     const std::vector<std::size_t>& frames);

}  // namespace coppermoon::uses
