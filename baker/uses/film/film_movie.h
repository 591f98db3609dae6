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
/// Where the film has pictures of high dynamic range, the film is one too (HDR10): HEVC, 10 bits in 4:2:0,
/// PQ, Rec.2020, with the film's light levels, and as mastering display the least that shows all of it.
///
/// Accuracy  of high dynamic range: light within 2 % where it is even, from 1 cd/m² on
/// Throws  Error  when ffmpeg is not there, or fails (with its own first words)
void write_movie(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

/// Light of a film of high dynamic range [cd/m²].
///
/// Source  CTA-861.3, annex P
struct LightLevels {
  double brightest = 0;       ///< of all pixels, by their brightest channel (MaxCLL)
  double brightest_mean = 0;  ///< of all frames (MaxFALL)
};

/// Given   pictures  .png, coded as PQ
/// Throws  Error     as texture::read_image
LightLevels light_levels(const std::vector<std::filesystem::path>& pictures);

}  // namespace coppermoon::uses
