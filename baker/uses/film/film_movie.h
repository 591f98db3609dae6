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

/// Refuses a movie that ends neither in .mp4 nor in .mov; an empty path asks for none.
///
/// Throws  Error
void require_movie_ending(const std::filesystem::path& path);

/// Encodes the pictures of some frames, in the order given, by ffmpeg, with the matrix of BT.709, tagged with primaries
/// and transfer characteristics of the film's display: H.264 in 4:2:0 where the file ends in .mp4, ProRes 422 HQ (10
/// bits) where it ends in .mov. An odd number of pixels on a side gets a black one more. The file appears whole or not
/// at all.
///
/// Pictures of high dynamic range, PQ and Rec.2020, become HDR10 in .mp4: HEVC, 10 bits in 4:2:0, with the film's light
/// levels, and the least mastering display that shows all of them. A .mov has no light levels.
///
/// Accuracy  of high dynamic range: light within 2 % where it is even, from 1 cd/m² on
/// Throws  Error  when ffmpeg is not there, or fails (with its own first words)
void write_movie(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

/// Light levels of a film of high dynamic range [cd/m²].
///
/// Source  CTA-861.3, annex P
struct LightLevels {
  double brightest = 0;       ///< MaxCLL: the brightest channel of any pixel
  double brightest_mean = 0;  ///< MaxFALL: the largest mean of a frame
};

/// Given   pictures  .png, coded as PQ
/// Throws  Error     as texture::read_image
LightLevels light_levels(const std::vector<std::filesystem::path>& pictures);

}  // namespace coppermoon::uses
