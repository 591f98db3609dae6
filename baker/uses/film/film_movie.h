// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Checks that ffmpeg can be run.
///
/// Throws  Error  when it cannot be run; the message names the package to install
void require_ffmpeg();

/// Refuses a movie whose name ends in neither .mp4 nor .mov. An empty path is accepted, and means no movie.
void require_movie_ending(const std::filesystem::path& path);

/// Encodes the frames' pictures with ffmpeg, in the order given. A file that ends in .mp4 is in H.264 (4:2:0), and one
/// that ends in .mov in ProRes 422 HQ (10 bits). The movie has the matrix of BT.709, and is tagged with the primaries
/// and transfer characteristics of the film's display. An odd width or height is increased by one black pixel. The file
/// appears complete or not at all.
///
/// If the film has pictures of high dynamic range (PQ, Rec.2020), an .mp4 becomes HDR10: HEVC (10 bits, 4:2:0) with the
/// film's light levels and the dimmest mastering display that can show them. A .mov has no light levels.
///
/// Accuracy  for high dynamic range, 2 % in luminance, in uniform areas of at least 1 cd/m²
/// Throws  Error  when ffmpeg is missing or fails; quotes the start of ffmpeg's message
void write_movie(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

/// Light levels of a film with high dynamic range [cd/m²].
///
/// Source  CTA-861.3, annex P
struct LightLevels {
  double brightest = 0;       ///< MaxCLL: the brightest channel in any pixel
  double brightest_mean = 0;  ///< MaxFALL: the largest mean over a frame
};

/// Light levels of a film, from its pictures, which must be PNG files coded in PQ.
///
/// Throws  Error  as texture::read_image
LightLevels light_levels(const std::vector<std::filesystem::path>& pictures);

}  // namespace coppermoon::uses
