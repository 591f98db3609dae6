// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Refuses a machine without ffmpeg.
///
/// Throws  Error  when it cannot be run: names the package
void require_ffmpeg();

/// Writes the pictures of some frames as a film, by ffmpeg, whole or not at all: H.264 in 4:2:0, tagged
/// BT.709, a frame for each picture in the order given; a side of an odd number of pixels gets one
/// more, black.
///
/// Throws  Error  when ffmpeg is not there, or fails (with its own first words)
void write_movie(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

}  // namespace coppermoon::uses
