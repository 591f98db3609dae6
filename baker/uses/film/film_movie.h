// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "uses/film/film.h"

namespace coppermoon::uses {

/// Refuses a machine without ffmpeg.
///
/// Throws  Error  when ffmpeg cannot be run: names the package
void require_ffmpeg();

/// Refuses a movie whose name ends in neither .mp4 nor .mov; an empty path asks for none.
///
/// Throws  Error
void require_movie_ending(const std::filesystem::path& path);

/// Encodes the frames' pictures with ffmpeg, in the order given, with the matrix of BT.709, tagged with the primaries
/// and transfer characteristics of the film's display: as H.264 in 4:2:0 if the file ends in .mp4, as ProRes 422 HQ (10
/// bits) if it ends in .mov. A side with an odd number of pixels gets one more, which is black. The file appears whole
/// or not at all.
///
/// Pictures of high dynamic range, PQ and Rec.2020, become HDR10 in .mp4: HEVC, 10 bits in 4:2:0, with the film's light
/// levels, and the smallest mastering display that shows all of them. A .mov has no light levels.
///
/// Accuracy  for high dynamic range, light within 2 % in even areas, from 1 cd/m² up
/// Throws  Error  when ffmpeg is missing, or fails (quotes the start of its message)
void write_movie(const std::filesystem::path& path, const Film& film,
                 const std::vector<std::size_t>& frames);

/// Light levels of a film with high dynamic range [cd/m²].
///
/// Source  CTA-861.3, annex P
struct LightLevels {
  double brightest = 0;       ///< MaxCLL: the brightest channel in any pixel
  double brightest_mean = 0;  ///< MaxFALL: the largest mean over a frame
};

/// Given   pictures  .png, coded as PQ
/// Throws  Error     as texture::read_image
LightLevels light_levels(const std::vector<std::filesystem::path>& pictures);

}  // namespace coppermoon::uses
