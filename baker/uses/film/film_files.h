// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "uses/film/film.h"
#include "uses/light/shard.h"

namespace coppermoon::uses {

/// Files that are made of a whole film, once its frames are there; empty: not.
struct FilmFiles {
  std::filesystem::path contact_sheet, movie, composite;
  std::vector<std::filesystem::path> curves;

  bool any() const;
};

/// Refuses files that could be made of no film.
///
/// Throws  Error  for a shard, which has not all frames; for an ending that a file cannot have
void require_sound(const FilmFiles& files, const Shard& shard);

/// Refuses files that cannot be made of this film, before any frame is made.
///
/// Throws  Error  for a place that a file cannot have; when the film's products lack what a file is
///                made of; without a font or ffmpeg
void require_makeable(const FilmFiles& files, const Film& film);

/// Makes them, each whole or not at all, in the frames' order of time.
///
/// Given   made   told each file once it is there; may be empty
/// Throws  Error  as write_contact_sheet, write_composite, write_curve, write_movie
void write_film_files(const FilmFiles& files, const Film& film, std::vector<std::size_t> frames,
                      const std::function<void(const std::filesystem::path&)>& made = {});

}  // namespace coppermoon::uses
